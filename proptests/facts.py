#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The numbers on the pages: each is counted here and has to be on its page.

  facts.py --program PATH                checks facts, runs (docs/runs.jsonl) and that no page states a time
  facts.py --program PATH --write        writes the table of runs into docs/how_it_is_tested.md
  facts.py --program PATH --self-check   checks that wrong numbers are noticed

A fact is a page, a sentence with {} in place of its numbers, and how they are counted: from the tree, from data or by
the program. Times depend on a machine; they belong into bench/ratios.json with the processor. Every
kind of certificate and every operation with one has a row in oracle/certificates/README.md."""
import argparse
import collections
import importlib
import json
import math
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.dont_write_bytecode = True
sys.path[:0] = [str(ROOT / folder) for folder in ("proptests", "proptests/mutation", "coverage", "robust/proofs",
                                                  "oracle/certificates/proved")]
WORDS = "zero one two three four five six seven eight nine ten eleven twelve".split()
MARKS = "<!-- made by proptests/facts.py -->\n", "<!-- end of what is made -->\n"
RUNS_PAGE = "docs/how_it_is_tested.md"
# Made by other scripts, or about the length of a step and not of a run.
WITHOUT_TIMES = {"docs/operations.md", "docs/deck.md", "docs/simulate_engines.md"}
NUMBER = rf"(?:\d[\d.,]*|{'|'.join(WORDS[1:])}|fifteen|twenty|thirty|half an?|quarter of an?)"
TIME = re.compile(rf"\b{NUMBER}(?: to {NUMBER})? (?:core-)?(?:milli|micro|nano)?(?:seconds?|minutes?|hours?)\b|"
                  r"\ban? (?:minute|hour)\b")


def text_of(path):
    return (ROOT / path).read_text(encoding="utf-8")


def flat(text):
    return " ".join(text.split())


def number(value):
    return f"{value:,}" if isinstance(value, int) else str(value)


def word(value):
    return WORDS[value]


def constant(path, pattern):
    """The number that a source states once."""
    found = re.findall(pattern, text_of(path), re.MULTILINE)
    if len(found) != 1:
        sys.exit(f"{path}: {pattern} is there {len(found)} times")
    return int(found[0].replace("'", ""))


def vectors():
    """(with an exact answer, refused)"""
    answered = refused = 0
    for path in (ROOT / "vectors").glob("*.jsonl"):
        for line in path.open(encoding="utf-8"):
            refused += '"refused":{' in line
            answered += '"truth":{' in line
    return answered, refused


def lines_of(*patterns):
    paths = [path for pattern in patterns for path in ROOT.glob(pattern)]
    return sum(len(path.read_text(encoding="utf-8").splitlines()) for path in paths)


def hundreds(count):
    """Rounded down, so that a new line seldom changes a page."""
    return count // 100 * 100


def fraction(pattern):
    return {0.5: "a half", 0.25: "a quarter", 0.125: "an eighth"}[float(re.search(pattern, text_of("dev")).group(1))]


def ratio_to_formula():
    """The greatest ratio of robust's full answer to the formula's on random cases, rounded up."""
    table = next(table for table in json.loads(text_of("bench/ratios.json")) if table["head"][0] == "full answer")
    return math.ceil(max(float(row[-1]) for row in table["rows"] if row[1] == "random"))


def mutants():
    listed = importlib.import_module("mutants").listed()
    return len(listed), len({number for number, _ in listed})


def proved_operations():
    kinds = importlib.import_module("kinds")
    return len(kinds.operations(kinds.sources()))


def right_hits(engine, gas, column=1):
    """Counts the hits of an exact gas that an engine answers rightly: one less than the hit at which it parts."""
    section = text_of("docs/simulate_engines.md").partition(f"### {gas}\n")[2].partition("###")[0]
    cells = re.search(rf"^\| {re.escape(engine)} \|(.*)\|$", section, re.MULTILINE).group(1).split("|")
    return int(cells[column - 1]) - 1


def energy(engine, scene, column=1):
    """A number of an engine's row in a scene's table: 1 is the change of energy."""
    section = text_of("docs/simulate_engines.md").partition(f"### {scene}\n")[2].partition("###")[0]
    cells = re.search(rf"^\| {re.escape(engine)} \|(.*)\|$", section, re.MULTILINE).group(1).split("|")
    return float(cells[column])


def engines_beside():
    table = text_of("docs/simulate_engines.md").partition("| engine | numbers |")[2].partition("###")[0]
    return len(re.findall(r"^\| \w|^\| @", table, re.MULTILINE))


def hits(gas):
    return int(re.search(r": (\d+) hits", text_of("docs/simulate_engines.md").partition(f"### {gas}\n")[2]).group(1))


PIPE = "audit/engines/pipe.h"


def facts(operations):
    """[(page, sentence, numbers)]"""
    by_chapter = collections.Counter(operation["chapter"] for operation in operations)
    structures = sum(o["chapter"] == "broad_phase" and "implementation_of" in o for o in operations)
    answered, refused = vectors()
    gates = importlib.import_module("gates").GATES
    planted, different = mutants()
    timeout, flight = constant(PIPE, r" timeout = (\d+);"), constant(PIPE, r" in_flight = (\d+);")
    restarts, in_a_row = constant(PIPE, r" restarts = (\d+);"), constant(PIPE, r" restarts_in_a_row = (\d+);")
    silences = constant(PIPE, r" timeouts = (\d+);")
    outcomes = "proptests/agreement/outcomes.cpp"
    judged, judged_dear = constant(outcomes, r"judged = (\d+),"), constant(outcomes, r"judged_dear = (\d+);")
    many, few = (constant("cmake/fuzz_targets.cmake", rf"set\(mutations ({n}\d*)\)") for n in (5, 1))
    of_users, of_gcc, of_clang = (fraction(name + r"=\$\{TOUCHSTONE_CASES:-([\d.]+)\}")
                                  for name in ("TOUCHSTONE_CASES", "asked", "of_clang"))
    # A test preset's environment would win over what ./dev asks.
    presets = json.loads((ROOT / "CMakePresets.json").read_text(encoding="utf-8"))["testPresets"]
    if any("TOUCHSTONE_CASES" in one.get("environment", {}) for one in presets if one["name"] in ("release", "clang")):
        sys.exit("CMakePresets.json: TOUCHSTONE_CASES of ./dev test full would not be asked")
    longest = constant("proptests/layout.py", r"^LONGEST = (\d+)")
    most_files = constant("proptests/floors.py", r"^MOST_FILES = (\d+)")
    checkers = [hundreds(lines_of(*of)) for of in (("oracle/certificates/*.cpp", "oracle/certificates/*.h"),
                                                   ("oracle/certificates/*.py",))]
    explained = "catalogue/operation/probes/explained.cpp"
    gas, plane = "gas_of_27", "gas_in_the_plane"
    bullet, ode, cannon = "Bullet 3.24", "ODE 0.16.2", "cannon-es 0.20.0"
    found = [
        ("README.md", "{} questions with exact answers and {} inputs that must be refused", (answered, refused)),
        ("README.md", "This engine, {} lines of Python,", (lines_of("examples/engine.py"),)),
        ("README.md", "asks at most {} questions of each operation",
         (constant("dev", r"set -- --cases (\d+) --by-cost"),)),
        ("README.md", "after {} restarts the operation is given up", (restarts,)),
        ("README.md", "it takes up to {} times as long as the textbook formula", (ratio_to_formula(),)),
        ("README.md", "{} operations in {} chapters", (len(operations), word(len(by_chapter)))),
        ("README.md", "by all pairs and by {} structures", (word(structures),)),
        *(("README.md", f"| [`{chapter}`](docs/operations.md#{chapter}) | {{}} |", (count,))
          for chapter, count in by_chapter.items()),
        ("CONTRIBUTING.md", "no file over {} lines", (longest,)),
        ("docs/architecture.md", "Do not let a file grow beyond {} lines, or a folder of the library beyond {} files",
         (longest, most_files)),
        ("docs/method.md", "{} lines of C++ and {} of Python",
         checkers),
        (RUNS_PAGE, "`./dev test` asks {} of the cases", (of_users,)),
        (RUNS_PAGE, "{} of the cases with g++ and {} with clang", (of_gcc, of_clang)),
        (RUNS_PAGE, "{} mutants, {} different changes", (planted, different)),
        (RUNS_PAGE, "with {} mutations of it ({} in `./dev test`)", (many, few)),
        (RUNS_PAGE, "and {} % of their branches", (f"{gates['branches']:g}",)),
        (RUNS_PAGE, "is [a theorem](proofs.md#certificates-that-are-proved-to-prove) for {} operations",
         (proved_operations(),)),
        ("docs/adding_an_operation.md", "at least {} mutants",
         (word(constant("proptests/layout.py", r"^FEWEST_MUTANTS = (\d+)")),)),
        ("docs/adding_an_operation.md", "the family's first {} questions ({} where a question is dear)",
         (judged, judged_dear)),
        ("docs/engines.md", "at most {} easy questions",
         (word(constant("audit/counting/easy_questions.cpp", r"wanted = (\d+);")),)),
        ("docs/engines.md", "Up to {} questions are in flight", (flight,)),
        ("docs/engines.md", "gives no answer for {} s (`--timeout`)", (timeout,)),
        ("docs/engines.md",
         "dies {} times in a row without an answer, or {} times in one operation, or times out {} times in it",
         (in_a_row, restarts, silences)),
        ("docs/engines.md", "none of at least {} answers", (constant("audit/counting/tally.cpp", r" many = (\d+);"),)),
        ("docs/engines_audited.md", "crashes {} times in one operation, or is silent {} times,", (restarts, silences)),
        ("docs/judging.md", "Beyond 2^{} steps the formula is not evaluated",
         (constant(explained, r"most_steps = std::uint64_t\{1\} << (\d+),"),)),
        ("docs/judging.md", "Beyond 2^{} steps no cause is sought",
         (constant(explained, r"most_exact_steps = .*<< (\d+);"),)),
        ("docs/many_machines.md", "At most an eighth of its time is lost, and at most {} seconds",
         (constant("program/runs/checkpoint.cpp", r"most\{([\d']+)\}") // 1000,)),
        ("docs/simulate.md", "`steps` ({})", (constant("simulate/world/scene.h", r" steps = (\d+);"),)),
        ("docs/simulate.md", "`moments` ({})", (constant("simulate/world/scene.h", r" moments = (\d+);"),)),
        ("docs/simulate_engines.md",
         "In the plane Box2D and planck answer {} of {} hits as they should, Chipmunk {} and ODE {}; "
         "in space ODE answers {} of {} and rapier {}, at 60 steps a second",
         (right_hits("Box2D 2.4.1", plane), hits(plane), right_hits("Chipmunk 7.0.3", plane), right_hits(ode, plane),
          right_hits(ode, gas), hits(gas), right_hits("@dimforge/rapier3d-compat 0.21.0", gas))),
        ("docs/simulate_engines.md", "ODE has 12 J after 64 steps (+{:.3g}), cannon-es +{:.3g},",
         (energy(ode, "newtons_cradle"), energy(cannon, "newtons_cradle"))),
        ("docs/simulate_engines.md", "Bullet +{:.2g}, cannon-es +{:.2g} and ODE +{:.1g}.",
         tuple(energy(engine, "two_balls_in_a_box") for engine in (bullet, cannon, ode))),
        ("docs/simulate_engines.md", "Bullet loses {:.2g} of 25 J, cannon-es {:.2g}.",
         tuple(-energy(engine, "unequal_masses") for engine in (bullet, cannon))),
        ("docs/simulate_engines.md", "takes {:.3g} of its 32.4 J instead of {:.3g}",
         tuple(-energy(engine, "fast_box") for engine in (bullet, "robust"))),
        ("docs/simulate_engines.md", "lift the resting stack by {:.2g} J",
         (energy("Box2D 2.4.1", "resting_stack_passes"),)),
        ("docs/simulate.md", "shows what {} engines do", (word(engines_beside()),)),
        ("docs/simulate.md", "what they do with {} scenes",
         (word(text_of("docs/simulate_engines.md").count("Energy at the start:")),)),
        ("docs/judging.md", "wrong by at most {} units",
         (constant("catalogue/operation/blame.cpp", r"most_units = (\d+);"),)),
        ("docs/judging.md", "With *K* = {}:",
         (constant("catalogue/operation/judged_numbers.h", r"explained_spreads = (\d+);"),)),
        ("docs/testing.md", "`always` asks {} questions", (constant("testing/asked.h", r" cases = (\d+),"),)),
        ("docs/vectors.md", "in at most {} lines",
         (max(lines_of(f"examples/vectors/consumer.{kind}") for kind in ("py", "mjs", "cpp")),)),
        ("docs/vectors.md", "({} per file;",
         (word(constant("program/commands/vectors_check.cpp", r"usually_shown = (\d+);")),)),
    ]
    return [(page, sentence.format(*(value if isinstance(value, float) else number(value) for value in numbers)))
            for page, sentence, numbers in found]


def untrue(texts, expected):
    """texts: {page: text}"""
    for page, sentence in expected:
        if flat(sentence) not in flat(texts[page]):
            yield f"{page}: it should say: {sentence}"


def times(texts, expected):
    """Measured times that no fact holds."""
    for page, text in texts.items():
        prose = flat(re.sub(r"```.*?```|`[^`\n]*`", "", text, flags=re.DOTALL))
        held = {found.group() for of, sentence in expected if of == page for found in TIME.finditer(sentence)}
        for found in TIME.finditer(prose):
            if found.group() not in held:
                yield f"{page}: {found.group()}: a time that depends on the machine"


# The kinds of certificates.

CERTIFICATES = "oracle/certificates/README.md"


def claimed():
    """{operation: kinds of certificates that its true claims have}"""
    kinds = {}
    for path in (ROOT / "oracle/certificates/claims").glob("*.jsonl"):
        true = [line for line in path.read_text(encoding="utf-8").splitlines() if '"refused"' not in line]
        if true:
            kinds[path.stem] = set(re.findall(r'"kind": ?"(\w+)"', "\n".join(true)))
    return kinds


def unexplained(page, kinds):
    """Operations that no row of the page names, and kinds of certificates that no row explains."""
    rows = "\n".join(re.findall(r"^\|.*", page, re.MULTILINE))
    for name in sorted(kinds.keys() | set().union(*kinds.values())):
        if f"`{name}`" not in rows:
            yield f"{CERTIFICATES}: no row has `{name}`"


# The runs.

def run_table(runs):
    lines = ["| command | asks | cases | outcomes | wrong | hash | a test repeats it |", "|---" * 7 + "|"]
    for run in runs:
        outcomes = ", ".join(f"{count:,} {name}" for name, count in run["outcomes"].items())
        lines.append(f"| `{run['command']}` | {run['asks']} | {run['cases']:,} | {outcomes} | {run['wrong']} | "
                     f"`{run['hash']}` | {'yes' if run['repeated'] else 'no'} |")
    return "\n".join(lines) + "\n"


def page_of(page, runs):
    before, _, rest = page.partition(MARKS[0])
    _, _, after = rest.partition(MARKS[1])
    return before + MARKS[0] + "\n" + run_table(runs) + "\n" + MARKS[1] + after


def repeated(program, runs):
    for run in runs:
        if run["repeated"]:
            done = subprocess.run([program, *run["command"].split(), "--json", "-"], check=True, stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL)
            told = json.loads(done.stdout)
            of = told["operations"][0]
            found = {"cases": told["of"], **{key: of[key] for key in ("outcomes", "wrong", "hash")}}
            if any(run[key] != value for key, value in found.items()):
                yield f"docs/runs.jsonl: {run['command']}: now it is {json.dumps(of)}"


def defects(program, texts, expected, runs):
    yield from untrue(texts, expected)
    yield from times({page: text for page, text in texts.items() if page not in WITHOUT_TIMES}, expected)
    if texts[RUNS_PAGE] != page_of(texts[RUNS_PAGE], runs):
        yield f"{RUNS_PAGE}: not what proptests/facts.py --write makes of docs/runs.jsonl"
    yield from unexplained(text_of(CERTIFICATES), claimed())
    yield from repeated(program, runs)


def self_check(program, texts, expected, runs):
    for page, sentence in expected:
        numbers = list(re.finditer(rf"[\d,]*\d|{'|'.join(WORDS)}|a half|a quarter|an eighth", sentence))
        changed = sentence[:numbers[-1].start()] + "7654" + sentence[numbers[-1].end():]
        wrong = {page: flat(texts[page]).replace(flat(sentence), flat(changed))}
        if not list(untrue(wrong, [(page, sentence)])):
            yield f"{page}: a wrong number was not noticed: {changed}"
    for planted in ("It takes 3 minutes.", "It takes two seconds a row.", "It takes 20 to 30 minutes.",
                    "After half a minute it ends.", "It takes an hour."):
        if not list(times({"a.md": planted}, [])):
            yield f"not noticed: {planted}"
    for innocent in ("`sleep 3 seconds` and no answer in 5 s", "two ulps", "seconds are told"):
        if list(times({"a.md": innocent}, [])):
            yield f"wrongly noticed: {innocent}"
    short = min((run for run in runs if run["repeated"]), key=lambda run: run["cases"])
    for key, value in (("hash", "0" * 16), ("cases", 1), ("wrong", 1), ("outcomes", {})):
        if not list(repeated(program, [{**short, key: value}])):
            yield f"a run with another {key} was not noticed"
    if page_of(texts[RUNS_PAGE], runs[:1]) == texts[RUNS_PAGE]:
        yield "a missing run was not noticed"
    if not list(unexplained(text_of(CERTIFICATES), claimed() | {"touch": {"feeling"}})):
        yield "a kind of certificates without a row was not noticed"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--program", type=pathlib.Path, required=True)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--self-check", action="store_true")
    options = parser.parse_args()
    runs = [json.loads(line) for line in text_of("docs/runs.jsonl").splitlines()]
    if options.write:
        (ROOT / RUNS_PAGE).write_text(page_of(text_of(RUNS_PAGE), runs), encoding="utf-8")
    listed = subprocess.run([options.program, "ops", "--json"], check=True, stdout=subprocess.PIPE).stdout
    pages = ["README.md", "CONTRIBUTING.md", *(f"docs/{path.name}" for path in sorted((ROOT / "docs").glob("*.md")))]
    check = self_check if options.self_check else defects
    expected = facts(json.loads(listed))
    found = list(check(options.program.resolve(), {page: text_of(page) for page in pages}, expected, runs))
    counted = f"{len(expected)} facts and {len(runs)} runs hold"
    right = "every wrong number is noticed" if options.self_check else counted
    print("\n".join(found) or right)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
