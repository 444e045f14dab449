#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The state of every operation, and what the tests are in numbers: build/status.md, made from the tree and the program.

  status.py --program PATH
"""
import argparse
import importlib
import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "proptests/infrastructure/oracle"))
sys.path.insert(0, str(ROOT / "coverage"))
sys.path.insert(0, str(ROOT / "robust/proofs"))
sys.path.insert(0, str(ROOT / "oracle/certificates/proved"))
sys.dont_write_bytecode = True
STAGES = ("filter", "enclosed", "lattice", "exact")
KINDS = {"decision": "enumerators are equal", "measure": "numbers in ulps", "set": "equal as sets",
         "checked": "a checker accepts it", "covering": "nothing is missing"}
PARTS_OF_FILTERS = {"FloatFormat", "Sign", "Meeting", "Bounds", "by_sign", "power_of_two", "extent", "apart", "slab",
                    "beyond_interval"}
UNPROVED = re.compile(r"Not proved by\s(?:\s*/// )?machine")  # as the comment of such a bound says


def text_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def lines_of(path):
    return sum(1 for line in text_of(path).splitlines() if line.strip())


def method_of_oracle(chapter, name):
    """Returns what its header says after "Truth:", up to the margin, and of the certificate."""
    comments = re.findall(r"(?:^///.*\n)+", text_of(f"oracle/{chapter}/{name}.h"), re.MULTILINE)
    for comment in (re.sub(r"\s*^/// ?", " ", comment, flags=re.MULTILINE).strip() for comment in comments):
        found = re.search(r"Truth[:,] (.*?) *(?=Margin|No margin|Certificate:|$)", comment)
        if found:
            return " ".join([found.group(1), *re.findall("Certificate: .*", comment)])
    sys.exit(f"oracle/{chapter}/{name}.h: no sentence 'Truth: ...'")


def stages_of(chapter, name):
    """Those that can be asked one by one."""
    text = text_of(f"robust/{chapter}/{name}.h").partition("namespace stages {")[2]
    return [stage for stage in STAGES if re.search(rf"static [^(;]* {stage}[(,;]", text)]


def sources_of(chapter, name):
    """The text of an operation of robust and of all that it includes of robust, but for the filters themselves."""
    filters = set(importlib.import_module("source").HEADERS)
    texts, left = {}, [f"robust/{chapter}/{name}.h"]
    while left:
        path = left.pop()
        if path in texts or path in filters or not (ROOT / path).is_file():
            continue
        texts[path] = text_of(path)
        left += re.findall(r'^#include "(robust/[^"]+)"', texts[path], re.MULTILINE) + [path.replace(".h", ".cpp")]
    return texts


def filters_of(chapter, name):
    """Those that it may ask, itself or by what it uses."""
    shown = {}  # of a function or class with a theorem, the name
    for title, function, *_ in importlib.import_module("extract").FILTERS:
        shown.update({part: title for part in function} if isinstance(function, tuple) else
                     {function.partition(".")[0]: function.partition(".")[0]})
    texts = sources_of(chapter, name).values()
    uses = r"\bfilters::(\w+)|^struct (Crossings) "
    used = {of[0] or of[1] for text in texts for of in re.findall(uses, text, re.MULTILINE)} - PARTS_OF_FILTERS
    cells = sorted({f"`{shown[part]}`" if part in shown else f"`{part}` (derived)" for part in used})
    cells += ["`enclosed.h`"] * ("enclosed" in stages_of(chapter, name))
    return cells + ["a bound of its own (derived)"] * any(UNPROVED.search(text) for text in texts)


def certificate_kinds(name):
    return sorted(set(re.findall(r'"certificate":\{"kind":"(\w+)"', text_of(f"vectors/{name}.jsonl"))))


def checker_proved(name):
    """Returns whether the checks of its certificates are proved: yes, no, or but for which kinds."""
    kinds = importlib.import_module("kinds")
    if name not in kinds.operations(kinds.sources()):
        return "-"
    tables = "".join(text_of(path.relative_to(ROOT)) for path in (ROOT / "oracle/certificates/proved").glob("operations_*.ml"))
    found = re.search(rf'operation ~unproved:\[ ?([^]]*?) ?\] "{name}"', tables)
    return "but for " + found.group(1).replace('"', "`").replace(";", ",") if found else "all"


def second_opinions():
    """({operation: [what]}, {operation: why there is no second truth})"""
    truths, without = importlib.import_module("simplest_truth").found()
    opinions = {name: ["a second truth in fractions"] for name in truths}
    for path in sorted((ROOT / "proptests").rglob("*.cpp")):
        text = path.read_text(encoding="utf-8")
        for what in re.findall(r"// (\w+) as second opinion:", text):
            for name in sorted(set(re.findall(r"[a-z0-9_]+", text))):
                opinions.setdefault(name, []).append(what)
    return opinions, without


def grids():
    """[(size, most configurations of a cost of 1)] of what the test run asks."""
    found = re.findall(r"\.size = (\d+), \.first = -?\d+, \.most = 1 << (\d+).*?\}, operation\.metadata\(\)\.list_length\)",
                       text_of("proptests/agreement/grids.cpp"))
    if len(found) < 2:
        sys.exit("proptests/agreement/grids.cpp: the sizes of the grids are no longer where this script looks")
    return [(int(size), 1 << int(bits)) for size, bits in found]


def configurations(program, name, size):
    """Returns their number, which a shard with none of them reports."""
    said = subprocess.run([program, "exhaust", name, "--grid", str(size), "--shard", f"1/{1 << 63}", "--json", "-"],
                          check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    return json.loads(said)["cases"]


def worlds(program, operation):
    """(a cell, configurations asked, whether one of them is asked as a whole)"""
    cells, total, whole = [], 0, False
    for size, most in grids():
        count = configurations(program, operation["name"], size)
        asked = min(count, most // operation["cost"])
        total += asked
        whole = whole or asked == count
        cells.append(f"{size}: all {count:,}" if asked == count else f"{size}: {asked:,} of {count:,}")
    return "; ".join(cells), total, whole


def table(program, operations):
    opinions, without = second_opinions()
    asked = 0
    columns = ["operation", "judged", "second opinion", "certificates", "checker proved", "small domains", "stages of robust", "proved",
               "mutants", "vectors", "open"]
    lines = [f"| {' | '.join(columns)} |", "|---" * len(columns) + "|"]
    for operation in operations:
        name, chapter = operation["name"], operation["chapter"]
        row = text_of(f"catalogue/rows/{chapter}/{name}.h")
        opinion = list(opinions.get(name, []))
        decision = re.search(r"^  struct decision \{\n(.*?)^  \};", row, re.MULTILINE | re.DOTALL)
        if decision and " oracle(" in decision.group(1):
            opinion.append("the oracle's quick decision")
        world, count, whole = worlds(program, operation)
        asked += count
        doubts = [] if name not in without else [without[name]]
        if not whole:
            doubts.append("no small domain is asked completely")
        stages = stages_of(chapter, name)
        lines.append("| " + " | ".join([
            f"`{name}`", KINDS[operation["kind"]], "; ".join(opinion) or "-",
            ", ".join(f"`{kind}`" for kind in certificate_kinds(name)), checker_proved(name), world, ", ".join(stages) or "-",
            ", ".join(filters_of(chapter, name)) or "-", str(lines_of(f"proptests/mutation/mutants/{name}.jsonl")),
            f"{lines_of(f'vectors/{name}.jsonl'):,}", "; ".join(doubts) or "-"]) + " |")
    return lines, asked


HEAD = """# Status of every operation

Made by `./dev status` from the tree (a test compares); nothing here is written by hand. The operations are in the order of the
chapters:

- *second opinion*: other programs that decide the same questions in the test run. The method of the oracle is
  [below](#how-the-oracle-decides).
- *certificates*: the kinds that the vectors have. Two programs check each
  ([what they prove](../oracle/certificates/README.md)).
- *checker proved*: the kinds for which a [theorem](proofs.md) says that they prove the truth.
- *small domains*: the number of values of each coordinate, and the configurations that the test run asks: all, or that
  many, evenly spread. `touchstone exhaust` asks the rest.
- *stages of robust*: in the order in which they run, if they can be run one by one. `filter` is double with a bound.
  `enclosed` has half as many digits more, and a rounding test. `lattice` has integers below 2^61, with products in 128
  bits. `exact` has integers of any size.
- *proved*: the filters and enclosures with [theorems](proofs.md) that it may use, itself or indirectly. `(derived)`: the
  bound is derived in a comment and tested. `-`: it has no such bound; it compares, or computes exactly.
- *mutants*: planted bugs, each of which the property suite, the vectors and fuzzing kill alone.
- *open*: known gaps.
"""


def status(program, operations):
    lines, asked = table(program, operations)
    methods = [f"- `{o['name']}`: {method_of_oracle(o['chapter'], o['name'])}" for o in operations]
    below = ["", "## How the oracle decides", "", "These are the words of the headers of `oracle/`.", "", *methods, ""]
    return "\n".join([HEAD, *lines, *below]), asked


def count_in(folder, pattern):
    return sum(len(re.findall(pattern, path.read_text(encoding="utf-8"), re.MULTILINE))
               for path in (ROOT / folder).rglob("*.cpp"))


def hundreds(count):
    """So that not every new test changes the page."""
    return f"more than {(count - 1) // 100 * 100:,}"


def files_in(folder):
    return sum(1 for path in (ROOT / folder).rglob("*") if path.is_file() and path.name != "README.md")


def claims():
    true = false = 0
    for path in (ROOT / "oracle/certificates/claims").glob("*.jsonl"):
        text = path.read_text(encoding="utf-8")
        refused = ["refused" in json.loads(line) for line in text.splitlines() if line.strip()]
        true, false = true + refused.count(False), false + refused.count(True)
    return true, false


def numbers(operations, asked):
    manifest = json.loads(text_of("vectors/manifest.json"))
    gates = importlib.import_module("gates").GATES
    environments = re.search(r"environment_count = (\d+);", text_of("catalogue/judge/environment.h")).group(1)
    mutants = sum(lines_of(path) for path in (ROOT / "proptests/mutation/mutants").glob("*.jsonl"))
    true, false = claims()
    truths, without = importlib.import_module("simplest_truth").found()
    rows = [
        ("operations", len(operations)),
        ("families of inputs, of all operations", sum(len(o["families"]) for o in operations)),
        ("properties that are tested for every operation", count_in("proptests/agreement", r"^EACH_OPERATION\(|\{Aspect::") - 1),
        ("other tests", hundreds(count_in("proptests", r"^ *(TEST_CASE|(ROBUST_|EXACT_)?LAW|CONTRACT)\("))),
        ("configurations of small domains in a test run", asked),
        ("operations with a second truth", sum(o["name"] in truths for o in operations)),
        ("floating-point environments", int(environments)),
        ("mutants, each killed in three ways", mutants),
        ("test vectors", manifest["vectors"]),
        ("claims that the checkers have to accept, and to refuse", f"{true:,}, {false:,}"),
        ("inputs that fuzzing starts from", hundreds(files_in("fuzz/corpus"))),
        ("inputs that fuzzing found, replayed", files_in("fuzz/findings")),
        ("lines of reference, robust and oracle that tests must reach", f"{gates['lines']:g} %"),
        ("branches of these", f"{gates['branches']:g} %"),
    ]
    return "| | |\n|---|---|\n" + "".join(f"| {what} | {n if isinstance(n, str) else f'{n:,}'} |\n" for what, n in rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", required=True)
    options = parser.parse_args()
    told = subprocess.run([options.program, "ops", "--json"], check=True, text=True, stdout=subprocess.PIPE).stdout
    operations = [operation for operation in json.loads(told) if "implementation_of" not in operation]
    for name in (operation["name"] for operation in operations):
        if not (ROOT / f"vectors/{name}.jsonl").is_file():
            sys.exit(f"vectors/{name}.jsonl: missing (./dev vectors {name})")
    page, asked = status(options.program, operations)
    written = ROOT / "build/status.md"
    written.parent.mkdir(exist_ok=True)
    written.write_text(page + "\n## The tests in numbers\n\n" + numbers(operations, asked), encoding="utf-8")
    print(f"written: {written}")


if __name__ == "__main__":
    main()
