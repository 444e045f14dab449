#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures the cost of operations: core-seconds of building and testing, handwritten lines, and whether
Metadata::cost is what a question costs. The exit code is 1 if the lines are over their bound. Seconds depend on the
machine: where they are over their goal, the table says so, and that is all.

  costs.py [--json FILE]   the builds in build/release (g++) and build/clang, after ./dev test or ./dev test full
  costs.py --self-check    a small made-up build, whose costs are known

A build job takes one core, and so does a test, unless its property PROCESSORS says more. A test that asks all operations
prints how long each took ("1.5 s: OPERATION: ..."); what such a test asks in vain is nobody's.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile

from handwritten import handwritten

ROOT = pathlib.Path(__file__).resolve().parent.parent
PRESETS = {"release": "g++", "clang": "clang"}
GOALS = {"lines": 600, "program": 600}
LINES_AT_MOST = 650  # it only falls
CACHED = 0.15  # s; an object that takes less came out of ccache
# proptests/agreement/interrogation.cpp: so many questions a family where one costs 1, and what that is in seconds.
QUESTIONS, LEAST, BATCH, UNIT = 4096, 8, 64, 45e-6
TESTS = re.compile(r"(^|/)(test_|fuzz|touchstone_fuzz|digest_|engine_|bench_|mutant_|vector_consumer|proptests/)")


def jobs(build):
    """{output: seconds} of the last time that each was built, from ninja's log: start, end (ms), mtime, output, hash.
    Outputs of one job share its time; outputs that are there no longer do not count."""
    last = {}
    for text in (build / ".ninja_log").read_text(encoding="utf-8").splitlines():
        fields = text.split("\t")
        if len(fields) == 5 and not os.path.isabs(fields[3]) and (build / fields[3]).exists():
            last[fields[3]] = (int(fields[0]), int(fields[1]), fields[4])
    of_job = collections.Counter(last.values())
    return {output: (end - start) / 1000 / of_job[start, end, hash] for output, (start, end, hash) in last.items()}


def tests(build):
    """[(name, core-seconds, {operation: seconds that the output gives it})]"""
    registered = "".join(path.read_text(encoding="utf-8") for path in build.rglob("CTestTestfile.cmake"))
    pattern = r'^set_tests_properties\(\[=*\[(.+?)\]=*\] PROPERTIES.*? PROCESSORS "(\d+)"'
    processors = dict(re.findall(pattern, registered, re.MULTILINE))
    found, name, parts = [], None, collections.Counter()
    log = build / "Testing/Temporary/LastTest.log"
    for text in log.read_text(encoding="utf-8", errors="replace").splitlines() if log.exists() else ():
        if begins := re.match(r"\d+/\d+ Testing: (.+)$", text):
            name, parts = begins[1], collections.Counter()
        elif part := re.match(r"([\d.]+) s: (\w+): ", text):
            parts[part[2]] += float(part[1])
        elif (ends := re.match(r"Test time = +([\d.]+) sec", text)) and name:
            found.append((name, float(ends[1]) * int(processors.get(name, 1)), parts))
            name = None
    return found


def measured_costs(ran, operations, factor):
    """{operation: (Metadata::cost, what the interrogation's time makes of it)}; factor: TOUCHSTONE_CASES."""
    seconds = next((parts for name, _, parts in ran if name == "agreement/interrogation"), {})
    costs = {}
    for operation in operations:
        cases = max(LEAST, QUESTIONS // operation["cost"])
        size = min(BATCH, cases)
        asked = len(operation["families"]) * max(1, int(cases // size * factor)) * size
        if operation["name"] in seconds:
            costs[operation["name"]] = operation["cost"], seconds[operation["name"]] / asked / UNIT
    return costs


def measure(root, operations, cores, factor):
    own = [o for o in operations if "implementation_of" not in o]
    result = {"operations": len(own), "cores": cores, "compilers": {}}
    total, testing, costs = 0.0, collections.Counter(), {}
    for preset, compiler in PRESETS.items():
        build = root / "build" / preset
        if not (build / ".ninja_log").is_file():
            continue
        made, ran = jobs(build), tests(build)
        objects = [seconds for output, seconds in made.items() if output.endswith((".o", ".gch", ".pch"))]
        costs = costs or measured_costs(ran, own, factor)
        for _, _, parts in ran:
            testing.update(parts)
        result["compilers"][compiler] = {
            "program": sum(seconds for output, seconds in made.items() if not TESTS.search(output)),
            "building": sum(made.values()), "testing": sum(seconds for _, seconds, _ in ran), "tests": len(ran),
            "objects": len(objects), "objects_cached": sum(seconds < CACHED for seconds in objects)}
        total += sum(made.values()) + sum(seconds for _, seconds, _ in ran)
    lines = handwritten(root, {o["name"]: o["chapter"] for o in own},
                        {o["name"]: o.get("implementation_of", o["name"]) for o in operations})
    most = max(lines, key=lambda name: sum(lines[name]))
    return result | {"minutes": total / 60 / cores, "costs": costs, "testing": dict(testing.most_common(5)),
                     "lines": {"mean": statistics.fmean(map(sum, lines.values())), "worst": sum(lines[most]),
                               "worst_operation": most}}


def too_long(costs):
    return costs["lines"]["mean"] > LINES_AT_MOST


def table(costs):
    """The lines of the table."""
    def row(what, value, goal=None):
        over = goal is not None and value > goal
        return f"{what:<60}{value:>10.1f}{'' if goal is None else f'   goal {goal:g}'}{'  OVER' if over else ''}"

    for compiler, of in costs["compilers"].items():
        yield row(f"{compiler}: core-seconds of building the program", of["program"], GOALS["program"])
        yield row(f"{compiler}: of building everything", of["building"])
        yield row(f"{compiler}: of {of['tests']} tests", of["testing"])
        if of["objects_cached"]:
            yield f"  {of['objects_cached']} of {of['objects']} objects came from ccache, so building seems cheaper than it is"
    yield row(f"minutes, {costs['operations']} operations, {costs['cores']} cores", costs["minutes"])
    yield row("handwritten lines, an operation, with mutants and claims: mean", costs["lines"]["mean"], GOALS["lines"])
    yield row(f"  worst: {costs['lines']['worst_operation']}", costs["lines"]["worst"])
    if too_long(costs):
        yield f"  over the bound of {LINES_AT_MOST} lines"
    dear = ", ".join(f"{name} {seconds:.0f} s" for name, seconds in costs["testing"].items())
    yield f"most expensive to test: {dear}" if dear else "no tests were run"
    for name, (said, measured) in costs["costs"].items():
        if not said / 3 <= max(1, measured) <= 3 * said:
            yield f"{name}: Metadata::cost is {said}, measured {measured:.1f}"


def self_check():
    """Two operations, and what each must cost, by hand."""
    operations = [{"name": "touch", "chapter": "lines", "cost": 1, "families": ["a", "b"]},
                  {"name": "touch_all", "chapter": "lines", "cost": 1024, "families": ["a"]}]
    log = "".join(f"{start}\t{end}\t1\t{output}\t{hash}\n" for start, end, output, hash in (
        (0, 9000, "a/touch.cpp.o", 1), (0, 2000, "a/touch.cpp.o", 1),  # built twice: the last time counts
        (0, 4000, "test_lines.dir/touch_all.cpp.o", 2), (0, 100, "a/quick.cpp.o", 7), (2, 5, "/elsewhere", 8)))
    done = "".join(f"1/9 Testing: {name}\n{said}Test time = {seconds} sec\n" for name, seconds, said in (
        ("agreement/interrogation", "  4.00", "1.000 s: touch: x\n0.036 s: touch_all: x\n0.5 s: y\n"),
        ("mutation/mutants_are_killed", " 20.00", "30.0 s: touch_all: mutants\n")))
    claims = "oracle/certificates/"
    files = {"build/release/.ninja_log": "# ninja log v5\n" + log, "build/release/Testing/Temporary/LastTest.log": done,
             "build/release/x/CTestTestfile.cmake":
                 'set_tests_properties([=[mutation/mutants_are_killed]=] PROPERTIES  PROCESSORS "2" TIMEOUT "9")\n',
             "reference/lines/touch.h": "1\n2\n", "catalogue/rows/lines/touch.h": "1\n", "robust/kernel/touch.h": "1\n",
             claims + "certify_lines.py": "def check_touch(c):\n    x\n\n    y\n\n\ndef check_touch_all(c):\n    z\n",
             claims + "claims/touch.jsonl": "{}\n", "proptests/mutation/mutants/touch.jsonl": "{}\n{}\n"}
    for output in ("a/touch", "test_lines.dir/touch_all", "a/quick"):
        files[f"build/release/{output}.cpp.o"] = ""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        costs = measure(pathlib.Path(folder), operations, 2, 1)
    built, shown = costs["compilers"]["g++"], "\n".join(table(costs))
    expected = [("program", built["program"], 2.1), ("building", built["building"], 6.1), ("testing", built["testing"], 44),
                ("cached", built["objects_cached"], 1), ("minutes", costs["minutes"], 50.1 / 120),
                ("dearest", costs["testing"]["touch_all"], 30.036), ("lines", costs["lines"]["worst"], 2 + 1 + 4 + 3),
                ("cost of touch", costs["costs"]["touch"][1], 1 / 8192 / UNIT),
                ("cost of touch_all", costs["costs"]["touch_all"][1], 0.036 / 8 / UNIT),
                ("not too long", too_long(costs), 0), ("too long", too_long({"lines": {"mean": LINES_AT_MOST + 1}}), 1),
                ("told", shown.count("Metadata::cost is 1024, measured 100.0"), 1), ("not told", shown.count("touch: Metadata"), 0)]
    wrong = [f"{what}: {got} instead of {wanted}" for what, got, wanted in expected if abs(got - wanted) > 1e-9]
    print(*wrong, f"self-check: {len(expected) - len(wrong)} of {len(expected)} as expected", sep="\n")
    return 1 if wrong else 0


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--json", metavar="FILE", type=pathlib.Path, help="the numbers to a file")
    arguments.add_argument("--self-check", action="store_true")
    options = arguments.parse_args()
    if options.self_check:
        return self_check()
    program = ROOT / "build/release/touchstone"
    if not program.exists():
        print("costs: build/release/touchstone is not built")
        return 0
    listing = subprocess.run([program, "ops", "--json"], check=True, capture_output=True, text=True).stdout
    factor = float(os.environ.get("TOUCHSTONE_CASES", "1"))
    costs = measure(ROOT, json.loads(listing), len(os.sched_getaffinity(0)), factor)
    print(*table(costs), sep="\n")
    if options.json:
        options.json.write_text(json.dumps(costs, indent=1) + "\n", encoding="utf-8")
    return 1 if too_long(costs) else 0


if __name__ == "__main__":
    sys.exit(main())
