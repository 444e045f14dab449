#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmarks and prints ratios: everything that is compared is timed in one process, in turns.

  bench/ratios.py [BUILD] [--ops a,b] [--repetitions N] [--write] [--guard] [--page FILE.html] [--keep FILE.json]
  bench/ratios.py --picture FILE.svg --times FILE.json

BUILD is the build directory (build/bench). A time is the least of N repetitions (default 15) of 10 ms each, or of three
where three take more than two seconds: other load only ever adds time. The ratios of the medians are printed beside those
that have a goal. --write puts the tables into bench/ratios.json and bench/README.md (tables.py), --page writes them with
bars and curves (page.py), --keep keeps the times of a run. --guard names what is worse than in bench/ratios.json by more
than 15 % (guard.py); the exit code is 1 then. --picture draws the README's picture from the times of this
run, or of one that was kept.
"""

import argparse
import json
import math
import os
import pathlib
import platform
import re
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile
import types

import guard
import page
import tables

ROOT = pathlib.Path(__file__).resolve().parent.parent
OF_ANGLES = {"parametric_circle", "interior_angles"}  # whose formulas call the library's cosine or arc tangent
TRIANGULATION = "triangulate_polygon_10000"
HULL, TENTH_OF_HULL = "convex_hull_1000000", "convex_hull_100000"
MESH = "polyhedron_complexity_100000"
PAIRS = "all_pairs_"
PREPARED = "prepared_"
ARRAYS = "arrays_"
FEW_REPETITIONS, SECONDS = 3, 2  # no more repetitions are made of a group of which so many take longer than this
SETS = ["random", "near_degenerate", "small_integer_grid", "scale_2^1012", "scale_2^-1074"]


class Times:
    """Nanoseconds a case of one group of benchmarks: name -> one number a repetition."""

    def __init__(self, program, group, repetitions):
        self.of, self.labels = {}, {}
        taken = self.run(program, group, min(repetitions, FEW_REPETITIONS))
        if repetitions > FEW_REPETITIONS and taken < SECONDS:
            self.run(program, group, repetitions - FEW_REPETITIONS)

    def run(self, program, group, repetitions):
        """Adds to the times; the seconds that were timed."""
        pattern = group.replace("^", ".")
        command = [program, f"--benchmark_filter=^{pattern}/", "--benchmark_format=json",
                   f"--benchmark_repetitions={repetitions}", "--benchmark_min_time=0.01",
                   "--benchmark_enable_random_interleaving=true"]
        done = subprocess.run(command, capture_output=True, text=True, check=True)
        taken = 0
        for run in json.loads(done.stdout)["benchmarks"] if done.stdout else []:
            if run["run_type"] == "iteration":
                if run.get("error_occurred"):
                    sys.exit(f"{run['name']}: {run['error_message']}")
                name = run["name"].rsplit("/", 1)[1]
                self.of.setdefault(name, []).append(1e9 / run["items_per_second"])
                self.labels[name] = run.get("label", "")
                taken += run["real_time"] * run["iterations"] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[run["time_unit"]]
        return taken

    def least(self, name):
        return min(self.of[name]) if name in self.of else None

    def ratio(self, above, below, of=min):
        return of(self.of[above]) / of(self.of[below]) if above in self.of and below in self.of else None


def names(program):
    listed = subprocess.run([program, "--benchmark_list_tests"], capture_output=True, text=True, check=True).stdout
    return [line for line in listed.split("\n") if line]


def groups(program, ops):
    found = dict.fromkeys(name.rsplit("/", 1)[0] for name in names(program))
    return [group for group in found if not ops or group.split("/")[0] in ops or "arrays" in ops and group.startswith(ARRAYS) or
            re.sub(r"_[23]d$", "", group.split("/")[0].removeprefix(ARRAYS)) in ops]


def written(value, unit=""):
    if value is None:
        return ""
    return f"{value:.2f}{unit}" if value < 9.95 else f"{value:.3g}{unit}" if value < 1000 else f"{value:.0f}{unit}"


def table(head, rows):
    return tables.Table(head, [[str(cell) for cell in row] for row in rows])


def decisions(timed):
    rows = []
    for group, t in timed.items():
        if "naive" in t.of:
            op, data = group.split("/")
            rows.append([op, data, written(t.least("naive")), written(t.least("robust")),
                         *(written(t.ratio(*pair)) for pair in [("robust", "naive"), ("robust", "usual"), ("epick", "robust"),
                                                                ("shewchuk", "robust"), ("epeck", "robust"), ("mpq", "robust")])])
    return table(["decision", "cases", "naive ns", "robust ns", "robust / naive", "robust / usual", "Epick / robust",
                  "Shewchuk / robust", "Epeck / robust", "mpq / robust"], rows)


def answers(timed):
    rows = []
    for group, t in timed.items():
        if "robust_answer" in t.of:
            op, data = group.split("/")
            rows.append([op, data, written(t.least("slide_answer")), written(t.least("robust_answer")),
                         written(t.ratio("robust_answer", "slide_answer"))])
    return table(["full answer", "cases", "slide ns", "robust ns", "robust / slide"], rows)


def truths(timed):
    rows = []
    million = lambda t, name: "" if t.least(name) is None else written(1e3 / t.least(name))
    for group, t in timed.items():
        if "truth" in t.of:
            op, data = group.split("/")
            rows.append([op, data, *(million(t, name) for name in ["decision", "truth", "certificate", "examination"])])
    return table(["oracle, million a second", "cases", "decision alone", "truth", "certificate", "examination"], rows)


def exhausted(timed):
    rows = [[*group.split("/"), written(1e3 / t.least("exhaust"))] for group, t in timed.items() if "exhaust" in t.of]
    return table(["exhaustive", "grid", "million cases a second"], rows)


def add_earcut(program, timed):
    """earcut's times under node beside ours, where both are there."""
    folder = ROOT / "build/npm"
    if not timed or shutil.which("node") is None or not list(folder.glob("**/node_modules/earcut")):
        return
    with tempfile.NamedTemporaryFile(suffix=".json") as shapes:
        subprocess.run([program, "--shapes", shapes.name], check=True)
        done = subprocess.run(["node", ROOT / "bench/earcut.mjs", folder, shapes.name, "30"], capture_output=True, text=True, check=True)
    for shape, nanoseconds in json.loads(done.stdout).items():
        timed[f"{TRIANGULATION}/{shape}"].of["earcut"] = [nanoseconds]


def triangulations(timed):
    million = lambda t, name: "not here" if t.least(name) is None else written(t.least(name) / 1e6)
    rows = [[group.split("/")[1], million(t, "robust"), million(t, "earcut"), written(t.ratio("robust", "earcut"))]
            for group, t in timed.items()]
    return table(["10,000 vertices", "robust ms", "earcut ms", "robust / earcut"], rows)


def hulls(timed):
    rows = []
    for group, t in timed.items():
        if group.startswith(HULL):
            data = group.split("/")[1]
            times = [written(t.least(name) / 1e6) if name in t.of else "" for name in ["robust", "epick", "qhull"]]
            small = timed.get(f"{TENTH_OF_HULL}/{data}")
            growth = written(t.least("robust") / small.least("robust")) if small else ""
            qhull = "no hull" if t.labels.get("qhull") == "0" else written(t.ratio("qhull", "robust"))
            rows.append([data, *times, written(t.ratio("epick", "robust")), qhull, growth, t.labels["robust"]])
    return table(["a million points", "robust ms", "Epick ms", "qhull ms", "Epick / robust", "qhull / robust",
                  "robust, to a tenth of them", "faces, or dimension"], rows)


def meshes(timed):
    rows = [[group.split("/")[1], *(written(t.least(name) / 1e6) for name in ["robust", "epick"]),
             written(t.ratio("robust", "epick")), t.labels["robust"]]
            for group, t in timed.items() if group.startswith(MESH)]
    return table(["99,224 faces", "robust ms", "Epick ms", "robust / Epick", "robust says"], rows)


def prepared(timed):
    """Microseconds a question; a shape that is made pays off after the questions in the last column."""
    rows = []
    for group, t in timed.items():
        us = lambda name: written(t.least(name) / 1e3) if name in t.of else ""
        saved = t.least("robust") - t.least("prepared")
        rows.append([group.removeprefix(PREPARED).replace("/", ", "), *(us(name) for name in ["robust", "prepared", "epick", "made"]),
                     written(t.ratio("robust", "prepared")), written(t.ratio("epick", "prepared")),
                     f"{max(1, math.ceil(t.least('made') / saved)):,}" if saved > 0 else "never"])
    return table(["one shape, many questions", "raw us", "prepared us", "Epick us", "made us", "raw / prepared", "Epick / prepared",
                  "pays off after"], rows)


def pairs(timed):
    rows = []
    for group, t in timed.items():
        n, data = group.removeprefix(PAIRS).split("/")
        ms = lambda name: written(t.least(name) / 1e6) if name in t.of else ""
        smaller = timed.get(f"{PAIRS}{int(n) // 10}/{data}")
        growth = written(math.log10(t.least("robust") / smaller.least("robust"))) if smaller else ""
        rows.append([f"{int(n):,} {data}", t.labels["robust"], *(ms(name) for name in ["robust", "certificate", "check", "cgal"]),
                     written(t.ratio("cgal", "robust")), growth, t.labels["certificate"],
                     written(t.ratio("tree_moved", "tree_anew")), written(t.ratio("tree_moved", "robust"))])
    return table(["boxes", "pairs", "robust ms", "with certificate", "its check", "CGAL ms", "CGAL / robust", "exponent of n",
                  "bytes a box", "tree: moved / anew", "tree: moved / all_pairs"], rows)


def arrays(timed):
    rows = []
    for group, t in timed.items():
        op, data = group.removeprefix(ARRAYS).split("/")
        if "read" in t.of:
            continue
        rows.append([op, data, *(written(t.least(name)) for name in ["naive", "naive_avx512", "portable", "avx2", "avx512"]),
                     *(written(t.ratio(*pair)) for pair in [("avx512", "naive"), ("avx512", "naive_avx512"), ("avx2", "naive_avx2"),
                                                            ("epick", "avx512"), ("shewchuk", "avx512")])])
    return table(["arrays", "cases", "naive ns", "naive AVX-512 ns", "portable ns", "AVX2 ns", "AVX-512 ns", "/ naive",
                  "/ naive AVX-512", "AVX2 / naive AVX2", "Epick / AVX-512", "Shewchuk / AVX-512"], rows)


def arrays_from_python(build):
    """Returns what bench/arrays_python.py prints, or why it is not run."""
    if not list((build / "python/touchstone").glob("_touchstone*.so")):
        return f"Arrays from Python: skipped, no module in {build}/python (ninja -C {build} touchstone_python)."
    done = subprocess.run([sys.executable, ROOT / "bench/arrays_python.py", build], capture_output=True, text=True)
    if done.returncode != 0:
        return f"Arrays from Python: skipped, {(done.stderr.strip() or 'no word').splitlines()[-1]}"
    return f"```\n{done.stdout.rstrip()}\n```"


def goals_of_arrays(timed):
    """As `goals` lists them."""
    median, found = statistics.median, []

    def ratio(group, above, below, bound, sign):
        t = timed[group]
        if above in t.of and below in t.of:
            found.append((f"{group}: {above} / {below}", bound, sign, t.ratio(above, below), t.ratio(above, below, median)))

    for group in timed:
        data = group.split("/")[1]
        if data == "random":
            ratio(group, "avx512", "naive", 0.5, -1)
            ratio(group, "avx512", "naive_avx512", 1.05, -1)
            ratio(group, "avx2", "naive_avx2", 1.2, -1)
            ratio(group, "epick", "avx512", 20, 1)
        elif data == "one_in_a_hundred_near":
            ratio(group, "avx512", "naive_avx512", 1.3, -1)
        elif data == "near_degenerate":
            ratio(group, "epick", "avx512", 10, 1)
        elif data == "from_memory":  # of the rate at which the same memory is read
            ratio(group, "read", "avx512", 0.9, 1)
    return found


def goals_of_pairs(timed):
    """As `goals` lists them."""
    median, found = statistics.median, []
    bounds = [("uniform", 15), ("clustered", 12), ("six_orders", 15), ("nine_orders", 15), ("one_huge", 8), ("lattice", 5), ("nested", 5)]
    for data, bound, n in [*((data, bound, 1000000) for data, bound in bounds), ("sticks", 3, 100000)]:
        t, smaller = (timed.get(f"{PAIRS}{size}/{data}") for size in (n, n // 10))
        if not t or not smaller:
            continue
        both = lambda value: (value(min), value(median))
        what = f"{PAIRS}{n}/{data}: "
        found.append((what + "CGAL / robust", bound, 1, *both(lambda of: t.ratio("cgal", "robust", of))))
        found.append((what + "exponent of n", 1.1, -1,
                      *both(lambda of: math.log10(of(t.of["robust"]) / of(smaller.of["robust"])))))
        found.append((what + "bytes a box of the certificate", 16, -1, *[float(t.labels["certificate"])] * 2))
        found.append((what + "check of the certificate, s", 0.5, -1, *both(lambda of: of(t.of["check"]) / 1e9)))
        if "tree_moved" in t.of:
            found.append((what + "a tenth moved / anew", 0.5, -1, *both(lambda of: t.ratio("tree_moved", "tree_anew", of))))
    return found


def goals(lines, oracle, more):
    """(what, bound, sign, measured by least times, by medians): sign -1 for "at most"; and `more` of them."""
    median, found = statistics.median, []

    def ratio(what, group, above, below, bound, sign):
        t = lines.get(group)
        if t and above in t.of and below in t.of:
            found.append((what, bound, sign, t.ratio(above, below), t.ratio(above, below, median)))

    def rate(what, group, name, bound):
        t = oracle.get(group)
        if t and name in t.of:
            found.append((what, bound, 1, 1e3 / min(t.of[name]), 1e3 / median(t.of[name])))

    ratio("orientation, random: robust / naive", "orientation/random", "robust", "naive", 1.3, -1)
    ratio("orientation, random: Epick / robust", "orientation/random", "epick", "robust", 7, 1)
    ratio("segment_segment, random: robust / naive", "segment_segment/random", "robust", "naive", 1.2, -1)
    ratio("segment_segment, random: Epick / robust", "segment_segment/random", "epick", "robust", 2.5, 1)
    for op in ["orientation", "segment_segment"]:
        for data, bound in [("near_degenerate", 3), ("small_integer_grid", 1), ("scale_2^1012", 1), ("scale_2^-1074", 1)]:
            ratio(f"{op}, {data}: Epick / robust", f"{op}/{data}", "epick", "robust", bound, 1)
    for size in [16, 1000]:
        group = f"point_in_polygon_{size}"
        ratio(f"{group}, random: robust / naive", f"{group}/random", "robust", "naive", 1.1, -1)
        for data in SETS:
            ratio(f"{group}, {data}: Epick / robust", f"{group}/{data}", "epick", "robust", 1, 1)
    ratio("point_plane, random: robust / naive", "point_plane/random", "robust", "naive", 1.3, -1)
    for op, bound in [("ray_triangle", 1.2), ("segment_triangle", 1.2), ("ray_aabb", 1.1), ("segment_aabb", 1.1),
                      ("ray_sphere", 1.5), ("segment_sphere", 1.5)]:
        ratio(f"{op}, random: robust / naive", f"{op}/random", "robust", "naive", bound, -1)
        ratio(f"{op}, random: Epick / robust", f"{op}/random", "epick", "robust", 2.5, 1)
    for group, t in lines.items():
        op, data = group.split("/", 1)
        if data == "random" and t.labels.get("robust_answer") == "numbers":
            bound = 20 if op in OF_ANGLES else 10
            ratio(f"{op}, random: robust's answer / slide's", group, "robust_answer", "slide_answer", bound, -1)
    ratio("bounding_sphere, random: robust's answer / miniball", "bounding_sphere/random", "robust_answer", "miniball", 3, -1)
    for group in lines:
        if group.startswith(TRIANGULATION):
            ratio(f"{group}: robust / earcut", group, "robust", "earcut", 1, -1)
    for data, epick, qhull in [("ball", 40, 10), ("grid", 40, 10), ("clusters", 40, 10), ("sphere", 10, 5)]:
        ratio(f"{HULL}/{data}: Epick / robust", f"{HULL}/{data}", "epick", "robust", epick, 1)
        ratio(f"{HULL}/{data}: qhull / robust", f"{HULL}/{data}", "qhull", "robust", qhull, 1)
    for group, t in lines.items():
        if group.startswith(HULL) and t.labels.get("qhull", "0") != "0" and group.split("/")[1] not in (
                "ball", "grid", "clusters", "sphere"):
            ratio(f"{group}: qhull / robust", group, "qhull", "robust", 0.5, 1)
    for group in lines:
        tenth = lines.get(group.replace(HULL, TENTH_OF_HULL))
        if group.startswith(HULL) and tenth:
            times = [of(lines[group].of["robust"]) / of(tenth.of["robust"]) for of in (min, median)]
            found.append((f"{group}: robust, to a tenth of the points", 10 ** 1.25, -1, *times))
    for grid in [3, 4, 10]:
        rate(f"segment_segment, exhaustive on the {grid}-grid, million a second", f"segment_segment/grid_{grid}",
             "exhaust", 20)
    rate("segment_segment, oracle's decision on random cases, million a second", "segment_segment/random", "decision", 2)
    rate("segment_segment, oracle's truth on random cases, million a second", "segment_segment/random", "truth", 2)
    return table(["goal", "bound", "measured", "by medians", ""],
                 [[what, ("at most " if sign < 0 else "at least ") + written(bound), written(least), written(by_median),
                   "met" if (least - bound) * sign >= 0 else "MISSED"] for what, bound, sign, least, by_median in found + more])


def circumstances(build):
    """The compiler, its flags and the kind of processor."""
    commands = json.loads((build / "compile_commands.json").read_text())
    command = shlex.split(next(c["command"] for c in commands if c["file"].endswith("bench/operations.cpp")))
    flags = " ".join(word for word in command if re.match(r"-(O|f|m|std|DNDEBUG)", word))
    compiler = next(word for word in command if re.search(r"(\+\+|clang|gcc)[^/]*$", word) and "ccache" not in word)
    version = subprocess.run([compiler, "--version"], capture_output=True, text=True).stdout.split("\n")[0]
    cpuinfo = pathlib.Path("/proc/cpuinfo")
    model = re.search(r"model name\s*: (.*)", cpuinfo.read_text()) if cpuinfo.exists() else None
    return f"{version}; {flags}; {model.group(1) if model else platform.machine()}."


def draw_picture(file, words, timed):
    drawn = page.picture(words, timed)
    if not file or not drawn:
        sys.exit("there are no times of arrays for the picture" if file else "--times is for --picture FILE.svg")
    file.write_text(drawn)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=ROOT / "build/bench")
    parser.add_argument("--ops", type=lambda text: text.split(","), default=[])
    parser.add_argument("--repetitions", type=int, default=15)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--guard", action="store_true")
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("--picture", type=pathlib.Path)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--times", type=pathlib.Path)
    options = parser.parse_args()
    if options.times:
        kept = json.loads(options.times.read_text())
        return draw_picture(options.picture, kept["circumstances"],
                            {name: {group: types.SimpleNamespace(of=of) for group, of in groups.items()} for name, groups in kept["timed"].items()})
    load = os.getloadavg()[0]
    timed = {}
    for name in ["operations", "polygons", "triangulation", "hulls", "meshes", "prepared", "pairs", "arrays", "oracle"]:
        program = str(options.build / "bench" / name)
        timed[name] = {}
        if options.ops and not pathlib.Path(program).exists():
            continue  # ./dev check builds only the program that has every operation
        for group in groups(program, options.ops):
            print(group, file=sys.stderr)
            timed[name][group] = Times(program, group, options.repetitions)
    if not any(timed.values()):
        sys.exit(f"{', '.join(options.ops)}: no program in {options.build / 'bench'} measures this")
    add_earcut(str(options.build / "bench/triangulation"), timed["triangulation"])
    decided = timed["operations"] | timed["polygons"]
    reached = goals(decided | timed["triangulation"] | timed["hulls"], timed["oracle"],
                    goals_of_pairs(timed["pairs"]) + goals_of_arrays(timed["arrays"]))
    parts = [circumstances(options.build), reached, decisions(decided), arrays(timed["arrays"]),
             "" if options.ops else arrays_from_python(options.build.resolve()), triangulations(timed["triangulation"]),
             hulls(timed["hulls"]), meshes(timed["meshes"]), prepared(timed["prepared"]), pairs(timed["pairs"]), answers(timed["operations"]),
             truths(timed["oracle"]), exhausted(timed["oracle"])]
    report = "\n\n".join(str(part) for part in parts if part)
    print(report)
    if options.page:
        command = shlex.join(["bench/ratios.py", *sys.argv[1:]])
        options.page.write_text(page.page(circumstances(options.build), command, options.repetitions, load, os.cpu_count(), timed, report))
        print(f"\npage: {options.page}")
    if options.keep:
        kept = {name: {group: t.of for group, t in groups.items()} for name, groups in timed.items()}
        options.keep.write_text(json.dumps({"circumstances": circumstances(options.build), "timed": kept}))
    if options.picture:
        draw_picture(options.picture, circumstances(options.build), timed)
    new = [part for part in parts if isinstance(part, tables.Table)]
    kept = tables.read(tables.DATA.read_text())
    if options.write:
        run = f"{circumstances(options.build)} One run of `bench/ratios.py {shlex.join(sys.argv[1:])}`."
        tables.keep(new, run)
    if options.guard:
        lines, found = guard.said(kept, new)
        print("\n".join(["", f"now: {circumstances(options.build)}", *dict.fromkeys(f"kept: {table.measured}" for table in kept), *lines]))
        sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
