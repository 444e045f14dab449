#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that every operation is in every module under its own name, and no module sees one that it must not.

  layout.py --program PATH   the source tree around this file, with the operations that the program knows
  layout.py --self-check     small trees with one defect each: every defect must be found
"""
import argparse
import json
import pathlib
import re
import subprocess
import sys
import tempfile

from draw_order import unordered_draws

MODULES = {
    "arithmetic": {"arithmetic"},
    "geometry": {"geometry"},
    "reference": {"geometry", "reference"},
    "robust": {"geometry", "robust"},
    "oracle": {"geometry", "oracle"},
    "catalogue": {"geometry", "reference", "robust", "oracle", "catalogue"},
    "audit": {"geometry", "reference", "robust", "oracle", "catalogue", "audit"},
    "simulate": {"geometry", "reference", "robust", "catalogue", "simulate"},
    "testing": {"geometry", "oracle", "robust", "catalogue", "audit", "testing"},
    "report": {"geometry", "oracle", "catalogue", "audit", "simulate", "report"},
    "program": {"geometry", "oracle", "catalogue", "audit", "simulate", "report", "program"},
    "c": {"oracle", "robust", "catalogue", "audit", "simulate", "report", "c"},
    "js": {"c", "js"},
    "python": {"robust", "c", "python"},
    "engines": {"geometry", "robust", "oracle", "program", "engines"},
    **dict.fromkeys(("proptests", "fuzz", "bench", "coverage", "examples")),
}
# The files of an operation: folder (before the chapter) and suffixes.
PLACES = {
    "reference": (".h",),
    "robust": (".h", ".cpp"),
    "oracle": (".h", ".cpp"),
    "catalogue/signatures": (".h",),
    "catalogue/rows": (".h",),
    "proptests/operations": (".cpp",),
}
# Another implementation of an operation's question has a row of its own, and a formula, a robust or both.
IMPLEMENTATION_PLACES = {"catalogue/rows"}
# Folders beside the chapters.
NO_CHAPTER = {"reference": {"standard"}, "robust": {"kernel", "rings", "hulls", "structures", "pairs", "prepared", "proofs", "batch", "c"}, "oracle": {"exact", "certificates", "rings"}}
# cmake/generate.py refuses to install these.
NOT_INSTALLED = ("robust/rings/", "robust/hulls/", "robust/pairs/")
# Headers that CMake makes.
MADE = {"audit/version.h", "robust/c/array_forms.h", "touchstone_robust.h"} | {
    f"catalogue/{made}.h" for made in ("rows/all", "rows/declared", "signatures/all")}
FEWEST_MUTANTS = 6
CODE = {".h", ".cpp", ".py", ".js", ".mjs"}
LONGEST = 400
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(["<])([^">]+)[">]', re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
FOREIGN_HEADER = re.compile(r"^(gmp|gmpxx|mpfr)\.h$|^CGAL/|^boost/multiprecision/")
FOREIGN_TYPE = re.compile(r"\b(mp[zqf]_class|mp[zqf]_t|mpfr_t|CGAL::\w+)")
CGAL_AS_PEER = re.compile(r"//.*\bCGAL as (peer|second opinion): *\S+")
CGAL_MAY_BE_PEER = ("proptests/", "bench/", "engines/")
# They refuse subnormals, or obey the locale.
LIBRARY_FUNCTION = re.compile(r"\bstd::(?:a?(?:sin|cos|tan)h?|atan2|exp2?|expm1|log(?:2|10|1p)?|pow|cbrt)(?= *\()")
OTHER_READER = re.compile(r"\b(?:sto(?:d|f|ld)|strto(?:d|f|ld)|atof)\b(?= *\()")


class Tree:
    def __init__(self, root):
        self.root, self.text = root, {}
        for module in MODULES:
            for path in sorted((root / module).rglob("*")):
                if path.is_file() and path.suffix in CODE:
                    self.text[path.relative_to(root).as_posix()] = path.read_text(encoding="utf-8")

    def includes(self, name):
        return [(quote, target) for quote, target in INCLUDE.findall(self.text[name])]


def operation_files(tree, operations):
    chapters = {operation["chapter"] for operation in operations}
    for place, suffixes in PLACES.items():
        wanted = {
            f"{place}/{o['chapter']}/{o['name']}{suffix}"
            for o in operations
            for suffix in suffixes
            if place in IMPLEMENTATION_PLACES or "implementation_of" not in o
        }
        allowed = wanted | {f"{place}/{o['chapter']}/{o['name']}{suffix}" for o in operations for suffix in suffixes}
        for name in sorted(wanted - tree.text.keys()):
            yield f"{name}: missing"
        folders = {p.name for p in (tree.root / place).glob("*") if p.is_dir()} - NO_CHAPTER.get(place, set())
        for name in sorted(tree.text):
            for folder in folders:
                if name.startswith(f"{place}/{folder}/") and name not in allowed:
                    yield f"{name}: stray file, no operation of that chapter has this name"


def claimed(tree, file):
    """Returns whether a file holds a true claim, and a false one."""
    text = (tree.root / file).read_text(encoding="utf-8") if (tree.root / file).is_file() else ""
    kinds = {"refused" in json.loads(line) for line in text.splitlines() if line.strip()}
    return False in kinds, True in kinds


def evidence(tree, operations):
    """Yields what an operation needs besides its files, module by module."""
    certify = "oracle/certificates/"
    checks = {suffix: "".join(text for name, text in tree.text.items() if name.startswith(certify) and name.endswith(suffix))
              for suffix in (".cpp", ".py")}
    for operation in operations:
        name = operation["name"]
        if "implementation_of" in operation:
            continue
        header, row = (tree.text.get(f"{place}/{operation['chapter']}/{name}.h", "") for place in ("robust", "catalogue/rows"))
        for alone in sorted(set(re.findall(rf"\b{name}_(?:side|relation)(?=\()", header))):
            if f"robust::{alone}(" not in row:
                yield f"catalogue/rows/{operation['chapter']}/{name}.h: no row evaluates robust::{alone}, the decision alone"
        staged = rf"TOUCHSTONE_STAGED_MODULES\({name}\)|stages =\s+(StagesEither<)?::touchstone::robust::stages::{name}\b"
        if "namespace stages {" in header and not re.search(staged, row):
            yield f"catalogue/rows/{operation['chapter']}/{name}.h: no row evaluates robust::stages::{name}, each stage alone"
        vectors, corpus = tree.root / f"vectors/{name}.jsonl", tree.root / f"fuzz/corpus/{name}"
        if not vectors.is_file() or not vectors.stat().st_size:
            yield f"vectors/{name}.jsonl: missing or empty (./dev vectors)"
        if not corpus.is_dir() or not any(corpus.iterdir()):
            yield f"fuzz/corpus/{name}: missing or empty (./dev seeds {name})"
        listed = f"proptests/mutation/mutants/{name}.jsonl"
        mutants = (tree.root / listed).read_text(encoding="utf-8").count("\n") if (tree.root / listed).is_file() else 0
        if mutants < FEWEST_MUTANTS:
            yield f"{listed}: {mutants} mutants of {name}, fewer than {FEWEST_MUTANTS}"
        if not re.search(rf'\{{\s*"{name}"\s*,\s*(check_|contact\()', checks[".cpp"]):
            yield f"{certify}check_*.cpp: no check of {name} in the table of a file"
        if not re.search(rf"^(def check_{name}\(|check_{name} = )", checks[".py"], re.MULTILINE):
            yield f"{certify}certify_*.py: no check_{name}"
        claims = f"{certify}claims/{name}.jsonl"
        for held, sort in zip(claimed(tree, claims), ("true", "false")):
            if not held:
                yield f"{claims}: no {sort} claim of {name}"


def directions(tree):
    for name in tree.text:
        module = name.split("/")[0]
        allowed = MODULES[module]
        for quote, target in tree.includes(name):
            other = target.removeprefix("touchstone/").split("/")[0]
            if module == "engines" and quote == '"' and f"engines/{target}" not in tree.text:
                yield f"{name}: engines/ is a project of its own and has no \"{target}\""
            if quote == '"' and target not in tree.text and target not in MADE and module not in ("engines", "examples"):
                yield f"{name}: there is no \"{target}\" from the root"
            if allowed is not None and other in MODULES and other not in allowed and "/" in target:
                yield f"{name}: {module} must not include {other} ({target})"
            if re.match(r"oracle/certificates/check[^/]*$", name) and other in MODULES and not target.startswith(
                    "oracle/certificates/"):
                yield f"{name}: the checker of certificates must not include {target}"


def cgal(tree):
    for name, text in tree.text.items():
        if not any(t.startswith("CGAL/") for _, t in tree.includes(name)):
            continue
        if not name.startswith(CGAL_MAY_BE_PEER):
            yield f"{name}: CGAL belongs in tests, benchmarks and engines"
        elif not CGAL_AS_PEER.search(text):
            yield f"{name}: includes CGAL without saying why (// CGAL as peer: ..., // CGAL as second opinion: ...)"


def public_headers(tree):
    """No exact number type, nor a header that is not installed, reaches a user of geometry, reference or robust."""
    for name in tree.text:
        if not re.match(r"(geometry|reference|robust)/.*\.h$", name) or name.startswith(("robust/kernel/", *NOT_INSTALLED)):
            continue
        stage = re.search(r"\bStage\b|\b\w+_(?:lattice|exact)(?=\()", COMMENT.sub("", tree.text[name]))
        if stage:
            yield f"{name}: {stage.group(0)}, a stage, in a public header"
        found = FOREIGN_TYPE.search(COMMENT.sub("", tree.text[name]))
        if found:
            yield f"{name}: {found.group(1)} in a public header"
        seen, waiting = set(), [name]
        while waiting:
            header = waiting.pop()
            if header in seen or header not in tree.text:
                continue
            seen.add(header)
            for _, target in tree.includes(header):
                if FOREIGN_HEADER.match(target):
                    yield f"{name}: reaches <{target}> through {header}"
                if target.startswith(NOT_INSTALLED):
                    yield f"{name}: reaches {target}, which is not installed, through {header}"
                waiting.append(target)
        if name.startswith("robust/") and "InvalidInput" in tree.text[name] and "geometry/invalid_input.h" not in seen:
            yield f"{name}: InvalidInput without geometry/invalid_input.h"


def draws(tree):
    """The same seed gives the same questions, whatever compiler built them and whatever C library they are linked with."""
    for name, text in tree.text.items():
        if name.endswith((".h", ".cpp")):
            for line, what in unordered_draws(text):
                yield f"{name}:{line}: {what}"
        found = LIBRARY_FUNCTION.search(COMMENT.sub("", text))
        if found and name.startswith(("catalogue/rows/", "catalogue/families/", "catalogue/draw/")):
            yield f"{name}: {found.group(0)}, which no two C libraries round alike; robust's are correctly rounded"


def circles(tree):
    """Folders of a module, and files at its top, see one another in one direction."""
    for module in MODULES:
        sees = {}
        for name in tree.text:
            if not name.startswith(f"{module}/"):
                continue
            for _, target in tree.includes(name):
                one, other = (part_of(module, path) for path in (name, target))
                if target.startswith(f"{module}/") and one != other:
                    sees.setdefault(one, {}).setdefault(other, f"{name} includes {target}")
        for one in sees:
            for other, why in sees[one].items():
                if one in reach(sees, other) | {other}:
                    yield f"{module}/{one}: a circle, {why}"


def part_of(module, path):
    """The folder below a module, or the file at its top without its suffix."""
    first = path.removeprefix(f"{module}/").split("/")
    return first[0] if len(first) > 1 else first[0].split(".")[0]


def reach(sees, start):
    reached, waiting = set(), [start]
    while waiting:
        fresh = sees.get(waiting.pop(), {}).keys() - reached
        reached |= fresh
        waiting += fresh
    return reached


def readers(tree):
    for name, text in tree.text.items():
        if name.endswith((".h", ".cpp")) and (found := OTHER_READER.search(COMMENT.sub("", text))):
            yield f"{name}: {found.group(0)}, reads numbers without nearest_double"


def lengths(tree):
    for name, text in tree.text.items():
        if (lines := text.count("\n")) > LONGEST:
            yield f"{name}: {lines} lines, more than {LONGEST}"


def defects(root, operations):
    if not operations:
        yield "the program knows no operations"
        return
    tree = Tree(root)
    for check in (operation_files, evidence):
        yield from check(tree, operations)
    for check in (directions, cgal, public_headers, circles, draws, readers, lengths):
        yield from check(tree)


CLAIM = '{"op":"touch"}\n'
FALSE_CLAIM = '{"op":"touch","refused":"truth: side is wrong"}\n'


def right_tree():
    files = {f"{place}/lines/touch{suffix}": "#pragma once\n" for place, suffixes in PLACES.items() for suffix in suffixes}
    files["geometry/points.h"] = "#pragma once\n"
    files["robust/kernel/filter.h"] = "#include <gmpxx.h>\nmpq_class exact();\n"
    files["robust/lines/touch.cpp"] = '#include "robust/lines/touch.h"\n#include "robust/kernel/filter.h"\n'
    files["reference/lines/touch.h"] = '#include "geometry/points.h"\n// not even mpq_class in a comment\n'
    files["oracle/exact/truth.h"] = "#include <gmpxx.h>\nmpq_class truth();\n"
    files["oracle/certificates/check.cpp"] = '#include "oracle/certificates/check.h"\n'
    files["oracle/certificates/check.h"] = "#include <gmpxx.h>\n"
    files["catalogue/hull.h"] = """Box hull(DrawStream& c) {
  const auto side = [&c](double size) { return size * one_to(c, 3); }, point = [&c] { return small_integer(c); };
  if (c.coin()) *place += up_to(c, 2);
  edges[c.below(3)] = turn(box(c), 1, c), edges[0] = 1 + (c.coin() ? up_to(c, 2) : side(1));
  return turn([](DrawStream& d) { return box(d); }, Box{box(c), box(c)}) << point() << point();  // a(c) + b(c)
}
"""
    files["catalogue/operation/row.h"] = ('#include "robust/lines/touch.h"\n#include "oracle/lines/touch.h"\n'
                                          '#include "catalogue/shape/shape.h"\n')
    files["catalogue/shape/shape.h"] = "#pragma once\n"
    files["program/main.cpp"] = '#include "catalogue/operation/row.h"\n'
    files["proptests/laws/peers.cpp"] = "// CGAL as peer: the same question to another library\n#include <CGAL/Epick.h>\n"
    files["fuzz/driver/replay_main.cpp"] = '#include "program/main.cpp"\n'
    files["vectors/touch.jsonl"] = CLAIM
    files["oracle/certificates/claims/touch.jsonl"] = CLAIM + FALSE_CLAIM
    files["fuzz/corpus/touch/seed"] = "seed"
    files["proptests/mutation/mutants/touch.jsonl"] = 6 * "{}\n"
    files["oracle/certificates/check_lines.cpp"] = 'Checks checks_of_lines() { return {{"touch", check_touch}}; }\n'
    files["oracle/certificates/certify_lines.py"] = "def check_touch(claim):\n    pass\n"
    return files


# One defect each: what is written where (None removes it), and the file that must be blamed.
PLANTED = [
    ("robust/lines/touch.cpp", None, "robust/lines/touch.cpp: missing"),
    ("oracle/lines/touch.h", None, "oracle/lines/touch.h: missing"),
    ("catalogue/rows/lines/touch.h", None, "catalogue/rows/lines/touch.h: missing"),
    ("catalogue/signatures/lines/touch.h", None, "catalogue/signatures/lines/touch.h: missing"),
    ("proptests/operations/lines/cross.cpp", "", "proptests/operations/lines/cross.cpp: stray"),
    ("reference/lines/cross.h", "", "reference/lines/cross.h: stray"),
    ("oracle/planes/touch.cpp", "", "oracle/planes/touch.cpp: stray"),
    ("geometry/points.h", '#include "reference/lines/touch.h"\n', "geometry/points.h: geometry must not include reference"),
    ("reference/lines/touch.h", '#include "robust/lines/touch.h"\n', "reference must not include robust"),
    ("robust/lines/touch.cpp", '#include "oracle/lines/touch.h"\n', "robust must not include oracle"),
    ("oracle/lines/touch.cpp", '#include <touchstone/robust/lines/touch.h>\n', "oracle must not include robust"),
    ("robust/kernel/filter.h", '#include "program/main.cpp"\n', "robust must not include program"),
    ("catalogue/operation/row.h", '#include "program/main.cpp"\n', "catalogue must not include program"),
    ("program/main.cpp", '#include "fuzz/driver/replay_main.cpp"\n', "program must not include fuzz"),
    ("robust/lines/touch.cpp", '#include "touch.h"\n', 'there is no \"touch.h\" from the root'),
    ("engines/touch.cpp", '#include "geometry/points.h"\n', 'engines/ is a project of its own and has no "geometry/points.h"'),
    ("engines/touch.cpp", "#include <touchstone/catalogue/hull.h>\n", "engines must not include catalogue"),
    ("oracle/certificates/check.cpp", '#include "oracle/exact/truth.h"\n', "the checker of certificates must not"),
    ("robust/kernel/filter.cpp", "#include <CGAL/Epick.h>\n", "CGAL belongs in tests"),
    ("bench/touch.cpp", "#include <CGAL/Epick.h>\n", "bench/touch.cpp: includes CGAL without saying why"),
    ("robust/lines/touch.h", "inline Side touch_side(int);\n", "no row evaluates robust::touch_side"),
    ("robust/lines/touch.h", "#include <gmpxx.h>\n", "robust/lines/touch.h: reaches <gmpxx.h>"),
    ("robust/lines/touch.h", '#include "robust/kernel/filter.h"\n', "robust/lines/touch.h: reaches <gmpxx.h>"),
    ("robust/lines/touch.h", "namespace stages {\nstruct touch;\n}\n", "no row evaluates robust::stages::touch"),
    ("robust/lines/touch.h", '#include "robust/rings/simple.h"\n', "rings/simple.h, which is not installed"),
    ("robust/lines/touch.h", "inline Side touch(int, Stage& decided);\n", "robust/lines/touch.h: Stage, a stage, in"),
    ("robust/lines/touch.h", "Side touch_exact(int);\n", "robust/lines/touch.h: touch_exact, a stage, in"),
    ("robust/lines/touch.h", "/// Throws InvalidInput.\n", "touch.h: InvalidInput without geometry/invalid_input.h"),
    ("geometry/points.h", "struct P { mpq_class x; };\n", "geometry/points.h: mpq_class in a public header"),
    ("catalogue/rows/lines/touch.h", "f(DrawStream& c) {\n turn(box(c), c.below(2));\n", "touch.h:2: two draws in one call"),
    ("catalogue/rows/lines/touch.h", "f(DrawStream& c) { turn(\n  move(a, b(c)), {1, d(c)});\n", "touch.h:2: two draws in one call"),
    ("fuzz/touch.cpp", "f(DrawStream& draws) { x = a(draws) - b(1, draws); }\n", "touch.cpp:1: two draws in one expression"),
    ("proptests/touch.h", "f(DrawStream& draws) { auto a = [&](int k) { return b(k, draws); }; turn(a(1), a(2)); }\n", "touch.h:1: two draws in one call"),
    ("catalogue/rows/lines/touch.h", "const double x = std::cos(u);\n", "touch.h: std::cos, which no two C libraries"),
    ("catalogue/shape/shape.h", '#include "catalogue/operation/row.h"\n', "catalogue/shape: a circle"),
    ("program/main.cpp", "double x = std::stod(text);\n", "program/main.cpp: stod, reads numbers"),
    ("program/main.cpp", "\n" * 401, "program/main.cpp: 401 lines"),
    ("vectors/touch.jsonl", None, "vectors/touch.jsonl: missing"),
    ("vectors/touch.jsonl", "", "vectors/touch.jsonl: missing or empty"),
    ("fuzz/corpus/touch/seed", None, "fuzz/corpus/touch: missing"),
    ("proptests/mutation/mutants/touch.jsonl", 5 * "{}\n", "5 mutants of touch, fewer than 6"),
    ("oracle/certificates/check_lines.cpp", '{{"touched", check_touched}}', "no check of touch in the table"),
    ("oracle/certificates/certify_lines.py", "def check_touched(claim):\n", "no check_touch"),
    ("oracle/certificates/claims/touch.jsonl", FALSE_CLAIM, "claims/touch.jsonl: no true claim of touch"),
    ("oracle/certificates/claims/touch.jsonl", CLAIM, "claims/touch.jsonl: no false claim of touch"),
    ("oracle/certificates/claims/touch.jsonl", None, "claims/touch.jsonl: no true claim of touch"),
    ("proptests/mutation/mutants/touch.jsonl", None, "0 mutants of touch, fewer than 6"),
]


def write(root, files):
    for name, text in files.items():
        path = root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")


def self_check():
    operations = [{"name": "touch", "chapter": "lines"}]
    implementation = {"name": "touch_slowly", "chapter": "lines", "implementation_of": "touch"}
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        write(root / "right", right_tree())
        wrong += [f"a right tree was blamed: {defect}" for defect in defects(root / "right", operations)]
        for own in ({"reference"}, {"robust"}, {"reference", "robust"}):
            tree = root / "implementation of its own" / " ".join(sorted(own))
            files = [f"{place}/lines/touch_slowly{suffix}" for place in own | {"catalogue/rows"} for suffix in PLACES[place]]
            write(tree, right_tree() | dict.fromkeys(files, ""))
            wrong += [f"a right implementation was blamed: {defect}" for defect in defects(tree, operations + [implementation])]
        if not list(defects(root / "right", [])):
            wrong.append("a program without operations was not noticed")
        for number, (name, text, blame) in enumerate(PLANTED):
            files = {other: held for other, held in right_tree().items() if other != name}
            if text is not None:
                files[name] = text
            write(root / str(number), files)
            found = list(defects(root / str(number), operations))
            if not any(blame in defect for defect in found):
                wrong.append(f"planted in {name}, expected '{blame}', found {found}")
    print(f"self-check: {len(PLANTED) + 5 - len(wrong)} of {len(PLANTED) + 5} as expected")
    return wrong


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    choice = arguments.add_mutually_exclusive_group(required=True)
    choice.add_argument("--program", help="the built program; its `ops --json` is the list of operations")
    choice.add_argument("--self-check", action="store_true")
    options = arguments.parse_args()
    listing = "[]" if options.self_check else subprocess.check_output([options.program, "ops", "--json"], text=True)
    root = pathlib.Path(__file__).resolve().parent.parent
    found = self_check() if options.self_check else list(defects(root, json.loads(listing)))
    print(*found, sep="\n", end="\n" * bool(found))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
