#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What an operation costs: core-seconds of building it and of its tests, and how long the test run takes with all the
operations that are to come. For information: the exit code is 0.

  costs.py [--json FILE]   the builds in build/release (g++) and build/clang, after ./dev test
  costs.py --self-check    a small made-up build, whose costs are known

A build job and a test take one core, unless the test's property PROCESSORS says more. What has an operation's name in
its path or name is that operation's; what has its chapter's name is divided among the operations of the chapter; of a
test that asks all operations an operation has the time that the test's output gives it ("1.5 s: OPERATION: ..."), or an
equal part; the rest is fixed.
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
# At most: what the project allows itself, with two cores.
LIMITS = {"building": 7, "building fixed": 450, "testing thin": 18, "minutes": 14, "projected": 35, "lines": 480}
MINUTES_HOLD_TO = 25  # operations, for which the limit of the minutes is meant
CACHED = 0.15  # s; an object that takes less came out of ccache
# Tests that ask every operation of the catalogue.
ASK_ALL = re.compile(r"^(agreement|vectors|mutation|flags)/"
                     r"|^oracle/(certificates|checkers_agree|tampered_claims|simplest_truth)$"
                     r"|^(codec/(choices|shapes)|engines/documented|program/vectors|robust/environments)$")
# A chapter's name stands alone in a file's name, or after what is made for each chapter.
CHAPTER_FILE = r"^(?:check_|certify_|test_|rows_)?{}(?:_\d+)?$"

# The operations to come, by the price of a question. thin: a few numbers. ring: one short list (points, vertices,
# slabs, bodies). mesh: a mesh, a point set whose hull is one, a long list, commands, a system of inequalities.
TO_COME = {
    "thin": "point_in_obb obb_obb sphere_sphere aabb_aabb closest_point_on_aabb sphere_aabb"  # volumes: 6 of 14
            " swept_sphere_plane swept_sphere_sphere swept_aabb_aabb"  # sweeps: 3 of 4
            " segment_triangle triangle_triangle"  # polyhedra: 2 of 6
            " reflect_wall reflect_plane elastic_collision inelastic_collision restitution_collision damped_reflection"
            " penalty_force contact_state rigid_body_collision"  # response: 9 of 13
            " ray_plane segment_plane ray_triangle ray_aabb segment_aabb ray_sphere segment_sphere sphere_plane"
            " aabb_plane triangle_aabb sphere_triangle closest_point_on_segment closest_point_on_triangle"
            " segment_segment_distance",  # mixed pairs: all 14
    "ring": "aabb_of_points bounding_sphere convex_hull_2d kdop_of_points point_in_kdop kdop_kdop"
            " obb_of_points"  # volumes: 7 of 14
            " momentum kinetic_energy",  # response: sums over bodies, 2
    "mesh": "convex_hull"  # volumes: 1, its certificate is a mesh
            " swept_convex_polyhedra"  # sweeps: 1
            " polyhedron_complexity point_in_convex_polyhedron point_in_polyhedron"
            " polyhedron_polyhedron"  # polyhedra: 4
            " all_pairs bounding_volume_hierarchy uniform_grid quadtree octree bsp_tree"  # broad phase: 6, long lists
            " simultaneous_collisions simulate",  # response: 2, a quadratic program and a scene
}
DEARER = 3  # what testing a class of which nothing is measured is taken to cost of the next cheaper one


def of_price(price):
    return "thin" if price < 8 else "ring" if price < 64 else "mesh"


class Catalogue:
    """operations: as `touchstone ops --json` lists them. A method belongs to the operation that it answers."""

    def __init__(self, operations):
        self.name = {o["name"]: o.get("method_of", o["name"]) for o in operations}
        own = [o for o in operations if "method_of" not in o]
        self.price = {o["name"]: of_price(o.get("price", 1)) for o in own}
        self.chapter = {o["name"]: o["chapter"] for o in own}
        self.longest_first = sorted(self.name, key=len, reverse=True)

    def owners(self, path):
        """The operations to which a file or test belongs; none: it is fixed."""
        for name in self.longest_first:
            if name in path:
                return [self.name[name]]
        stems = [part.split(".")[0] for part in path.split("/")]
        for chapter in set(self.chapter.values()):
            if any(re.match(CHAPTER_FILE.format(re.escape(chapter)), stem) for stem in stems):
                return [name for name in self.chapter if self.chapter[name] == chapter]
        return []


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


def tests(build, catalogue):
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
            if part[2] in catalogue.name:
                parts[catalogue.name[part[2]]] += float(part[1])
        elif (ends := re.match(r"Test time = +([\d.]+) sec", text)) and name:
            found.append((name, float(ends[1]) * int(processors.get(name, 1)), parts))
            name = None
    return found


def shared(catalogue, building, testing):
    """({operation: core-seconds}, fixed) of building, and of testing."""
    build, build_fixed, test, test_fixed = collections.Counter(), 0.0, collections.Counter(), 0.0

    def divide(into, owners, seconds):
        for owner in owners:
            into[owner] += seconds / len(owners)
        return 0.0 if owners else seconds

    for output, seconds in building.items():
        build_fixed += divide(build, catalogue.owners(output), seconds)
    for name, seconds, parts in testing:
        owners = catalogue.owners(name)
        if not owners and parts:
            test.update(parts)
            test_fixed += max(0.0, seconds - sum(parts.values()))
        else:
            test_fixed += divide(test, owners or (list(catalogue.price) if ASK_ALL.match(name) else []), seconds)
    return (build, build_fixed), (test, test_fixed)


def mean(values):
    values = list(values)
    return statistics.fmean(values) if values else 0.0


def measure(root, operations, cores):
    catalogue = Catalogue(operations)
    result = {"operations": len(catalogue.price), "cores": cores, "compilers": {}, "testing": {}}
    testing, fixed, by_class = collections.Counter(), 0.0, collections.defaultdict(lambda: [0.0, 0])
    building = collections.Counter()
    for preset, compiler in PRESETS.items():
        build = root / "build" / preset
        if not (build / ".ninja_log").is_file():
            continue
        made = jobs(build)
        ran = tests(build, catalogue)
        (each, build_fixed), (asked, test_fixed) = shared(catalogue, made, ran)
        objects = [seconds for output, seconds in made.items() if output.endswith((".o", ".gch", ".pch"))]
        worst = max(catalogue.price, key=lambda name: each[name])
        result["compilers"][compiler] = {
            "mean": mean(each[name] for name in catalogue.price), "worst": each[worst], "worst_operation": worst,
            "fixed": build_fixed,
            "objects": len(objects), "objects_cached": sum(seconds < CACHED for seconds in objects),
            "testing": sum(asked.values()), "testing_fixed": test_fixed, "tests": len(ran),
            "operations": dict(each)}
        building.update(each)
        testing.update(asked)
        fixed += build_fixed + test_fixed
    per_class = {}
    for price in ("thin", "ring", "mesh"):
        names = [name for name, of in catalogue.price.items() if of == price]
        cheaper = per_class[{"ring": "thin", "mesh": "ring"}[price]]["testing"] if price != "thin" else 0.0
        per_class[price] = {"operations": len(names), "assumed": not names,
                            "building": mean(building[name] for name in names or catalogue.price),
                            "testing": mean(testing[name] for name in names) if names else DEARER * cheaper}
    to_come = {price: set(names.split()) - catalogue.price.keys() for price, names in TO_COME.items()}
    now = fixed + sum(building.values()) + sum(testing.values())
    later = now + sum(len(names) * (per_class[price]["building"] + per_class[price]["testing"])
                      for price, names in to_come.items())
    lines = handwritten(root, catalogue.chapter, catalogue.name)
    most = max(lines, key=lambda name: lines[name][0])
    return result | {
        "testing": per_class, "testing_operations": dict(testing),
        "minutes": now / 60 / cores, "minutes_projected": later / 60 / cores,
        "operations_projected": len(catalogue.price) + sum(map(len, to_come.values())),
        "to_come": {price: len(names) for price, names in to_come.items()},
        "lines": {"mean": mean(own for own, _ in lines.values()), "worst": lines[most][0], "worst_operation": most,
                  "mutants_and_claims": mean(data for _, data in lines.values())}}


def table(costs):
    """The lines of the table."""
    def row(what, values, limit=None):
        over = limit is not None and max(values) > limit
        cells = "".join(f"{value:>10.{0 if value >= 100 else 1}f}" for value in values)
        return f"{what:<60}{cells:<20}{'' if limit is None else f'{limit:>9g}'}{'  OVER' if over else ''}".rstrip()

    compilers, per_class, scale = costs["compilers"], costs["testing"], 2 / costs["cores"]
    yield f"{'costs, in core-seconds':<60}" + f"{''.join(f'{name:>10}' for name in compilers):<20}" + f"{'at most':>9}"
    if not compilers:
        yield "nothing is built: ./dev test"
        return
    yield row("building, an operation: mean", [of["mean"] for of in compilers.values()], LIMITS["building"])
    yield row("  worst: " + ", ".join(dict.fromkeys(of["worst_operation"] for of in compilers.values())),
              [of["worst"] for of in compilers.values()])
    yield row("building, fixed", [of["fixed"] for of in compilers.values()], LIMITS["building fixed"])
    for price, of in per_class.items():
        what = f"{price}, assumed {DEARER} x the cheaper" if of["assumed"] else f"{price}, mean of {of['operations']}"
        yield row(f"testing in all, an operation: {what}", [of["testing"]], LIMITS.get(f"testing {price}"))
    yield row("testing, all operations", [of["testing"] for of in compilers.values()])
    yield row("testing, fixed", [of["testing_fixed"] for of in compilers.values()])
    limit = LIMITS["minutes"] * scale if costs["operations"] <= MINUTES_HOLD_TO else None
    what = f"minutes from nothing, {costs['operations']} operations, {costs['cores']} cores"
    yield row(what, [costs["minutes"]], limit)
    coming = ", ".join(f"{count} {price}" for price, count in costs["to_come"].items())
    yield row(f"  with {costs['operations_projected']} operations ({coming} to come)", [costs["minutes_projected"]],
              LIMITS["projected"] * scale)
    lines = costs["lines"]
    yield row("handwritten lines, an operation: mean", [lines["mean"]])
    yield row(f"  worst: {lines['worst_operation']}", [lines["worst"]])
    yield row("  mean with mutants and claims", [lines["mean"] + lines["mutants_and_claims"]], LIMITS["lines"])
    cached = ", ".join(f"{of['objects_cached']} of {of['objects']} ({name})" for name, of in compilers.items())
    missing = [f"not built with {name}" for name in PRESETS.values() if name not in compilers]
    missing += [f"no tests run with {name}" for name, of in compilers.items() if not of["tests"]]
    if missing:
        yield "and the sums are too small: " + ", ".join(missing)
    yield f"objects from ccache (less than {CACHED} s), which make building seem cheaper than it is: {cached}"


def self_check():
    """Two operations of one chapter, and what each must cost, by hand."""
    operations = [{"name": "touch", "chapter": "lines"}, {"name": "touch_all", "chapter": "lines", "price": 8},
                  {"name": "touch_slowly", "chapter": "lines", "method_of": "touch"}]
    log = "".join(f"{start}\t{end}\t1\t{output}\t{hash}\n" for start, end, output, hash in (
        (0, 9000, "a/touch.cpp.o", 1), (0, 2000, "a/touch.cpp.o", 1),  # built twice: the last time counts
        (0, 4000, "a/touch_all.cpp.o", 2), (0, 500, "a/touch_slowly.cpp.o", 3), (0, 3000, "rows/lines.cpp.o", 4),
        (0, 10000, "kernel/outlines.cpp.o", 5), (0, 6000, "a/touch_gone.cpp.o", 6), (0, 100, "a/quick.cpp.o", 7),
        (2, 5, "/elsewhere", 8)))
    done = "".join(f"1/9 Testing: {name}\n{said}Test time = {seconds} sec\n" for name, seconds, said in (
        ("lines/touch", "  2.00", ""),
        ("agreement/a", "  4.00", "1.500 s: touch: x\n1.000 s: touch_all: x\n0.5 s: y\n"),
        ("mutation/mutants_are_killed", " 20.00", "30.0 s: touch_all: mutants\n6.0 s: touch: mutants\n"),
        ("vectors/hold", "  1.00", ""), ("install/prefix", "  7.00", "")))
    claims = "oracle/certificates/"
    files = {"build/release/.ninja_log": "# ninja log v5\n" + log, "build/release/Testing/Temporary/LastTest.log": done,
             "build/release/x/CTestTestfile.cmake":
                 'set_tests_properties([=[mutation/mutants_are_killed]=] PROPERTIES  PROCESSORS "2" TIMEOUT "9")\n',
             "reference/lines/touch.h": "1\n2\n", "catalogue/rows/lines/touch_slowly.h": "1\n",
             "robust/kernel/touch.h": "1\n",
             claims + "check_lines.cpp": "Complaint check_touch(const Claim& c) {\n  x;\n}\n\nvoid f() {\n}\n",
             claims + "certify_lines.py": "def check_touch(c):\n    x\n\n    y\n\n\ndef check_touch_all(c):\n    z\n",
             claims + "claims/touch.jsonl": "{}\n", "proptests/mutation/mutants/touch.jsonl": "{}\n{}\n"}
    for output in ("a/touch", "a/touch_all", "a/touch_slowly", "rows/lines", "kernel/outlines", "a/quick"):
        files[f"build/release/{output}.cpp.o"] = ""
    with tempfile.TemporaryDirectory() as folder:
        for name, text in files.items():
            path = pathlib.Path(folder, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, encoding="utf-8")
        costs = measure(pathlib.Path(folder), operations, 2)
    built, testing = costs["compilers"]["g++"], costs["testing"]
    now = 9.5 + 10.1 + 41.5 + 12.5
    coming = 34 * (4 + 10) + 9 * (5.5 + 31.5) + 14 * (4.75 + 94.5)
    shown, over = (" ".join(table(costs | changed)) for changed in ({}, {"minutes_projected": LIMITS["projected"] + 1}))
    expected = [("touch", built["operations"]["touch"], 2 + 0.5 + 1.5), ("fixed", built["fixed"], 10.1),
                ("touch_all", built["operations"]["touch_all"], 4 + 1.5),
                ("cached", built["objects_cached"], 1), ("objects", built["objects"], 6),
                ("thin", testing["thin"]["testing"], 2 + 1.5 + 6 + 0.5), ("mesh", testing["mesh"]["testing"], 3 * 31.5),
                ("ring", testing["ring"]["testing"], 1 + 30 + 0.5), ("fixed", built["testing_fixed"], 1.5 + 4 + 7),
                ("minutes", costs["minutes"], now / 120), ("to come", sum(costs["to_come"].values()), 57),
                ("projected", costs["minutes_projected"], (now + coming) / 120),
                ("lines", costs["lines"]["worst"], 2 + 1 + 3 + 4), ("data", costs["lines"]["mutants_and_claims"], 1.5),
                ("no mark", shown.count("OVER"), 0), ("mark", over.count("OVER"), 1)]
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
    costs = measure(ROOT, json.loads(listing), len(os.sched_getaffinity(0)))
    print(*table(costs), sep="\n")
    if options.json:
        options.json.write_text(json.dumps(costs, indent=1) + "\n", encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
