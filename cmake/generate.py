#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes files of what the sources declare (declarations.py), when CMake configures and when it installs.

  generate.py files SOURCE BUILD C_HEADERS VERSION            what is compiled or printed
  generate.py headers SOURCE MADE DESTINATION COMPONENT...    the headers that users get; lists where they come from
  generate.py order ROW...                                    lists the names of rows in the order of the deck
  generate.py own-namespace FILE...                           lists the tests that have a namespace of their own
  generate.py --self-check                                    a small tree, and one defect in each of its sources

`files` makes touchstone_robust.h in C_HEADERS; in BUILD array_forms/ and generated/robust/c/array_forms.h
(array_forms.py), certify/check_files.h, the table of the checker, and embedded/contracts.h, the comments of reference/.
A file that has not changed is not written."""
import pathlib
import re
import sys
import tempfile

import array_forms
from declarations import INCLUDE, Undeclared, checks, contract, has_own_namespace, place, text_of

# The headers that users get: these, and what they include.
PUBLIC = {
    "geometry": ["geometry/*.h"],
    "reference": ["reference/*/*.h"],
    "robust": ["robust/masked_exceptions.h", "robust/*/*.h"],
    "oracle": ["oracle/truth.h", "oracle/*/*.h"],
    "certify": ["oracle/certificates/check.h"],
    "judge": [],
    "audit": ["program/engine_main.h", "audit/engines/adapter.h", "audit/engines/fuzz.h",
              "catalogue/operation/operation.h", "record.h"],
    "testing": ["testing/*.h"],
    "c": [],
}
# Folders that hold no operations; of these a header is copied only where a public one includes it.
INNER = re.compile("(robust/(kernel|rings|hulls|pairs|c)|oracle/(exact|rings|certificates))/")
# No public header may reach these.
NEVER_PUBLIC = re.compile("(report|engines|robust/(rings|hulls|pairs))/")


def write(path, text):
    path.parent.mkdir(parents=True, exist_ok=True)
    if not path.exists() or text_of(path) != text:
        path.write_text(text, encoding="utf-8")


def filled(template, parts):
    return re.sub(r"@(\w+)@", lambda name: parts[name[1]], text_of(template))


def write_files(root, build, c_headers, version):
    parts = array_forms.made(root) | {"PROJECT_VERSION": version}
    write(c_headers / "touchstone_robust.h", filled(root / "robust/c/touchstone_robust.h.in", parts))
    write(build / "array_forms/touchstone_robust.cpp", filled(root / "robust/c/touchstone_robust.cpp.in", parts))
    for name in ("_decisions.py", "arrays.py"):
        write(build / "array_forms" / name, filled(root / f"python/touchstone/{name}.in", parts))
    write(build / "generated/robust/c/array_forms.h", f"""\
// Made by cmake/array_forms.py from the headers of robust/batch.
#pragma once

/// TOUCHSTONE_ARRAY_FORMS(form): form(NAME) for each touchstone_NAME of touchstone_robust.h.
#define TOUCHSTONE_ARRAY_FORMS(form) \\
{parts["forms"]}
/// TOUCHSTONE_PREPARED_FORMS(form): form(NAME, Shape, touchstone_SHAPE) for each touchstone_NAME_prepared.
#define TOUCHSTONE_PREPARED_FORMS(form) \\
{parts["prepared_forms"]}
""")

    listed = list(filter(None, map(checks, map(text_of, sorted((root / "oracle/certificates").glob("check*.cpp"))))))
    declared = "".join(f"Checks {name}();\n" for name in listed)
    write(build / "certify/check_files.h", f"""#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {{

{declared}
constexpr Checks (*checks_of_all_files[])() = {{{", ".join(listed)}}};

}}  // namespace touchstone::certify
""")

    contracts = ""
    for row in sorted(path.relative_to(root / "catalogue/rows") for path in (root / "catalogue/rows").glob("*/*.h")):
        text = contract(f"reference/{row}", text_of(root / "reference" / row), row.stem)
        contracts += f'    {{"{row.stem}", R"text({text})text"}},\n'
    write(build / "embedded/contracts.h", f"""#pragma once

namespace touchstone::report {{

constexpr struct {{
  const char *operation, *text;
}} contracts[] = {{
{contracts}}};

}}  // namespace touchstone::report
""")


def place_of(header, source, made):
    return source / header if (source / header).exists() else made / header


def public_headers(source, made, components):
    """The headers of these components and all that they include, as paths below source or made."""
    waiting = []
    for pattern in (pattern for component in components for pattern in PUBLIC[component]):
        found = [path.relative_to(source).as_posix() for path in sorted(source.glob(pattern))]
        waiting += [path for path in found if "/*/" not in pattern or not INNER.match(path)] if found else [pattern]
    reached = {}
    while waiting:
        header = waiting.pop(0)
        if header in reached:
            continue
        reached[header] = text_of(place_of(header, source, made))
        for _, included in INCLUDE.findall(reached[header]):
            if NEVER_PUBLIC.match(included):
                raise Undeclared(f"{header}: includes {included}, which is not for users")
            waiting.append(included)
    return reached


def write_headers(source, made, destination, components):
    """Our sources name each other from the root of the repository; a user may have a geometry/ too, so the copies say
    <touchstone/geometry/points.h>. destination/touchstone holds these headers after this, and no others."""
    headers = public_headers(source, made, components)
    for old in (destination / "touchstone").rglob("*"):
        if old.is_file() and old.relative_to(destination / "touchstone").as_posix() not in headers:
            old.unlink()
    for header, text in headers.items():
        write(destination / "touchstone" / header, INCLUDE.sub(r"\1<touchstone/\2>", text))
    return [place_of(header, source, made) for header in headers]


# A tree in which each of these is declared once, and what is wrong with it after one change.
TREE = {
    "geometry/points.h": "struct Point {};\n/// Where it lies,\n/// seen from a.\n"
                         "enum class Side { left, on,\n  right };\n",
    "robust/batch/isa/columns.h": "struct Column {\n  Column() = default;\n};\n"
                                  "struct Points2 {\n  Column x, y;  // side by side\n};\n",
    "robust/batch/turn.h":
        '#include "robust/batch/isa/columns.h"\n/// robust::turn of each a,\n/// its Side: left 0.\n'
        "void turn(const Points2& a, const Points2& b, std::size_t count, std::uint8_t* answers);\n",
    "robust/batch/within.h":
        '#include "robust/batch/isa/columns.h"\nclass Fixed;\n/// robust::within of one mesh, its Side: left 0.\n'
        "void within(const Meshd& mesh, const Points2& a, std::size_t count, std::uint8_t* answers);\n/// The same.\n"
        "void within(const Fixed& solid, const Points2& a,\n std::size_t count, std::uint8_t* answers);\n",
    "robust/prepared/solid.h": "class Fixed {\n};\n",
    "robust/masked_exceptions.h": '#include "made.h"\n',
    "reference/lines/turn.h": "\n/// Left or right.\n///\n/// Page 3.\ntemplate <class Real>\nSide turn(Real a);\n",
    "catalogue/rows/lines/turn.h": "",
    "oracle/certificates/check.cpp": "Checks checks();\n",
    "oracle/certificates/check_lines.cpp": "Checks checks_of_lines() { return {}; }\n",
    "robust/c/touchstone_robust.h.in": "@PROJECT_VERSION@@shapes_in_c@@enumerations_in_c@@functions_in_c@@prepared_in_c@",
    "robust/c/touchstone_robust.cpp.in": "@includes@@operands@@checks@@functions@",
    "python/touchstone/_decisions.py.in":
        "@decisions_in_help@@exported@@shapes_in_python@@enumerations_in_python@@functions_in_python@",
    "python/touchstone/arrays.py.in": "@masks_in_help@",
    "build/generated/made.h": "",
}
MADE = {
    "build/generated/touchstone_robust.h": [
        "1.2.3", "touchstone_column x, y;", "touchstone_column_rows(first + 1, stride)", "TOUCHSTONE_SIDE_RIGHT = 2",
        "/* Where it lies,\n * seen from a. */", "/* `turn` of each a,\n * its Side: left 0. */",
        "int touchstone_turn(touchstone_points2 a, touchstone_points2 b,\n",
        "int touchstone_fixed_make(touchstone_mesh mesh, touchstone_fixed** made,",
        "int touchstone_within_prepared(const touchstone_fixed* solid, touchstone_points2 a, size_t count,\n"],
    "build/array_forms/touchstone_robust.cpp": ['#include "geometry/points.h"\n#include "robust/batch/turn.h"',
                                                "operand(of.y)", "Side::on) == TOUCHSTONE_SIDE_ON"],
    "build/array_forms/_decisions.py": ["  turn(a, b)  Side: left, on, right", "POINTS2 = Shape(x=None, y=None)",
                                        "class Side", "def turn(a: Operand, b: Operand, *, out"],
    "build/generated/robust/c/array_forms.h": ["  form(turn) \\\n", "  form(within, Fixed, touchstone_fixed) \\\n"],
    "build/certify/check_files.h": ["Checks checks_of_lines();", "= {checks_of_lines};"],
    "build/embedded/contracts.h": ['{"turn", R"text(\nLeft or right.\n\nPage 3.)text"},'],
    "build/include/touchstone/robust/batch/turn.h": ["#include <touchstone/robust/batch/isa/columns.h>"],
    "build/include/touchstone/robust/batch/isa/columns.h": ["struct Points2"],
    "build/include/touchstone/made.h": [""],
}
WRONG = [
    ("geometry/points.h", "Side", "Place", "declares the enumeration Side"),
    ("robust/batch/isa/columns.h", "Column x, y", "std::size_t x", "columns.h: Points2: expected columns"),
    ("robust/batch/turn.h", "void turn", "void turns", "turn.h: no contract stands above void turn"),
    ("robust/batch/turn.h", "const Points2& a", "Points2 a", "turn.h: expected const SHAPE& operand, found: Points2 a"),
    ("robust/batch/turn.h", "const Points2& a", "const Points3& a", "operand, found: const Points3& a"),
    ("robust/batch/turn.h", " its Side:", "", "turn.h: the contract does not name the enumeration"),
    ("reference/lines/turn.h", "/// Page 3.\n", "", None),
    ("reference/lines/turn.h", "Side turn(", "Side turns(", "reference/lines/turn.h: no contract stands above turn"),
    ("geometry/points.h", "struct", '#include "robust/hulls/side.h"\nstruct', "which is not for users"),
]


def complaint(change=("", "", "")):
    """Returns what is wrong with the tree after a change of (file, from, to), or None."""
    with tempfile.TemporaryDirectory() as folder:
        root = pathlib.Path(folder)
        build = root / "build"
        for name, text in TREE.items():
            write(root / name, text.replace(*change[1:], 1) if name == change[0] else text)
        try:
            write_files(root, build, build / "generated", "1.2.3")
            write_headers(root, build / "generated", build / "include", ["geometry", "robust"])
        except Undeclared as found:
            return str(found)
        for name, expected in MADE.items():
            text = text_of(build.parent / name)
            if missing := [each for each in expected if each not in text and not change[0]]:
                return f"{name}: without {missing}:\n{text}"
        return None


def self_check():
    failures = [f"the right tree: {complaint()}"] if complaint() else []
    for file, before, after, expected in WRONG:
        found = complaint((file, before, after))
        if found is None if expected else found is not None:
            failures.append(f"{file}: {before} -> {after}: {found}, expected {expected}")
        elif expected and expected not in found:
            failures.append(f"{file}: {before} -> {after}: {found}, expected {expected}")
    namespace = "namespace touchstone::proptests::turn_tests {\n"
    if not has_own_namespace(namespace, "turn") or has_own_namespace(namespace, "turns"):
        failures.append("the namespace of a test")
    places = [place("turn.h", f'.pages = "{pages}",') for pages in ("14", "2, 14-15", "45-47, 51")]
    if places != [(14, 0), (14, 15), (51, 0)]:
        failures.append(f"the pages of rows: {places}")
    print("\n".join(failures) or "declarations are found, and missing ones are reported")
    return 1 if failures else 0


def main(arguments):
    if arguments == ["--self-check"]:
        return self_check()
    command, paths = arguments[0], [pathlib.Path(argument) for argument in arguments[1:]]
    try:
        if command == "files":
            write_files(*paths[:3], arguments[4])
        elif command == "headers":
            print(";".join(map(str, write_headers(*paths[:3], arguments[4:]))))
        elif command == "order":
            print(";".join(path.stem for path in sorted(paths, key=lambda row: (place(row, text_of(row)), row.stem))))
        elif command == "own-namespace":
            print(";".join(str(path) for path in paths if has_own_namespace(text_of(path), path.stem)))
    except Undeclared as found:
        sys.exit(str(found))
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
