#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The gates: every line, and at least 95 % of the branches, of reference, robust and oracle.

  gates.py COVERAGE.json COVERAGE.lcov   as llvm-cov export writes them; 1 if a module is below its gate
  gates.py --self-check                  a module below each gate must be refused, one above both accepted
"""
import collections
import json
import pathlib
import sys

MODULES = ("reference", "robust", "oracle")
GATES = {"lines": 100.0, "branches": 95.0}


def module_and_name(path):
    """The module and the path from the root: the last part of the path that begins with a module's name."""
    parts = pathlib.PurePath(path).parts
    for i in reversed(range(len(parts))):
        if parts[i] in MODULES:
            return parts[i], "/".join(parts[i:])
    return None, path


def missed_lines(lcov):
    missed, name = collections.defaultdict(list), None
    for line in lcov.splitlines():
        if line.startswith("SF:"):
            name = module_and_name(line[3:])[1]
        elif line.startswith("DA:"):
            number, count = line[3:].split(",")[:2]
            if int(count) == 0:
                missed[name].append(int(number))
    return missed


def percent(counts):
    covered, count = counts
    return 100.0 * covered / count if count else 100.0


def totals_by_module(export):
    totals = {module: collections.defaultdict(lambda: [0, 0]) for module in MODULES}
    for file in export["data"][0]["files"]:
        module, _ = module_and_name(file["filename"])
        if module is None:
            continue
        for kind in ("lines", "branches", "mcdc"):
            summary = file["summary"].get(kind, {"covered": 0, "count": 0})
            totals[module][kind][0] += summary["covered"]
            totals[module][kind][1] += summary["count"]
    return totals


def below_gate(totals):
    defects = []
    for module in MODULES:
        if totals[module]["lines"][1] == 0:
            defects.append(f"{module}: nothing of it was counted")
        for kind, gate in GATES.items():
            if percent(totals[module][kind]) < gate:
                covered, count = totals[module][kind]
                defects.append(f"{module}: {covered} of {count} {kind} ({percent(totals[module][kind]):.2f} %), the gate is {gate:g} %")
    return defects


def show(export, totals, lcov):
    missed = missed_lines(lcov)
    for file in sorted(export["data"][0]["files"], key=lambda f: f["filename"]):
        module, name = module_and_name(file["filename"])
        lines, branches = file["summary"]["lines"], file["summary"]["branches"]
        if module is None or (lines["covered"] == lines["count"] and branches["covered"] == branches["count"]):
            continue
        where = " lines " + ",".join(map(str, missed[name])) if missed[name] else ""
        print(f"  {name}: branches {branches['covered']}/{branches['count']}{where}")
    print(f"{'module':<10} {'lines':>18} {'branches':>18} {'MC/DC':>18}")
    for module in MODULES:
        cells = []
        for kind in ("lines", "branches", "mcdc"):
            covered, count = totals[module][kind]
            cells.append(f"{covered}/{count} {percent((covered, count)):6.2f} %" if count else "not counted")
        print(f"{module:<10} {cells[0]:>18} {cells[1]:>18} {cells[2]:>18}")


def self_check():
    def export(lines, branches):
        summary = {"lines": {"covered": lines, "count": 100}, "branches": {"covered": branches, "count": 100}}
        return {"data": [{"files": [{"filename": f"/x/{module}/a.h", "summary": summary} for module in MODULES]}]}

    expected = [((100, 95), 0), ((100, 100), 0), ((99, 100), 3), ((100, 94), 3), ((99, 94), 6)]
    wrong = [case for case, defects in expected if len(below_gate(totals_by_module(export(*case)))) != defects]
    if not below_gate(totals_by_module({"data": [{"files": []}]})):
        wrong.append("nothing counted")
    print(f"self-check: {'failed: ' + str(wrong) if wrong else 'as expected'}")
    return 1 if wrong else 0


def main(arguments):
    if arguments == ["--self-check"]:
        return self_check()
    if len(arguments) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    export = json.loads(pathlib.Path(arguments[0]).read_text(encoding="utf-8"))
    totals = totals_by_module(export)
    show(export, totals, pathlib.Path(arguments[1]).read_text(encoding="utf-8"))
    defects = below_gate(totals)
    for defect in defects:
        print(f"below the gate: {defect}")
    return 1 if defects else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
