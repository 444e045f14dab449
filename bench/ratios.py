#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmarks and prints ratios: everything that is compared is timed in one process, in turns.

  bench/ratios.py [BUILD] [--ops a,b] [--programs a,b] [--repetitions N] [--write] [--guard] [--page FILE.html]
                  [--keep FILE.json] [--times FILE.json] [--picture FILE.svg]

BUILD is the build directory (build/bench). A time is the least of N repetitions (default 15) of 10 ms each, or of three
where three take more than two seconds: other load only ever adds time. The ratios of the medians are printed beside those
that have a goal. --write puts the tables into bench/ratios.json and bench/README.md (tables.py), --page writes them with
bars and curves (page.py), --picture draws the README's picture. --keep adds the times to those in FILE, program by
program, so that a long run can be made in parts (--programs); --times prints, writes and draws what was kept, and times
nothing. --guard names what is worse than in bench/ratios.json by more than 15 % (guard.py); the exit code is 1 then.
"""

import argparse
import dataclasses
import json
import math
import os
import pathlib
import platform
import re
import shlex
import shutil
import subprocess
import sys
import tempfile

import guard
import page
import tables
from goals import (ARRAYS, HULL, MESH, PAIRS, PREPARED, TENTH_OF_HULL, TRIANGULATION, goals, goals_of_pairs, table,
                   table_of_arrays, written)

ROOT = pathlib.Path(__file__).resolve().parent.parent
PROGRAMS = ["operations", "polygons", "triangulation", "hulls", "meshes", "mesh_rays", "mesh_points", "prepared", "distances",
            "pairs", "arrays", "oracle"]
FEW_REPETITIONS, SECONDS = 3, 2  # no more repetitions are made of a group of which so many take longer than this


class Times:
    """Nanoseconds a case of one group of benchmarks: name -> one number a repetition."""

    def __init__(self, of=None, labels=None):
        self.of, self.labels = of or {}, labels or {}

    def measure(self, program, group, repetitions):
        taken = self.run(program, group, min(repetitions, FEW_REPETITIONS))
        if repetitions > FEW_REPETITIONS and taken < SECONDS:
            self.run(program, group, repetitions - FEW_REPETITIONS)
        return self

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
                name = peer_of(run["name"])
                self.of.setdefault(name, []).append(1e9 / run["items_per_second"])
                self.labels[name] = run.get("label", "")
                taken += run["real_time"] * run["iterations"] * {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1}[run["time_unit"]]
        return taken

    def least(self, name):
        return min(self.of[name]) if name in self.of else None

    def ratio(self, above, below, of=min):
        return of(self.of[above]) / of(self.of[below]) if above in self.of and below in self.of else None


def peer_of(name):
    return name.removesuffix("/real_time").rsplit("/", 1)[1]


def names(program):
    """But those that are run once, which measure no time."""
    listed = subprocess.run([program, "--benchmark_list_tests"], capture_output=True, text=True, check=True).stdout
    return [line for line in listed.split("\n") if line and not line.endswith("/iterations:1")]


def groups(program, ops):
    found = dict.fromkeys(name.removesuffix("/real_time").rsplit("/", 1)[0] for name in names(program))
    return [group for group in found if not ops or group.split("/")[0] in ops or "arrays" in ops and group.startswith(ARRAYS) or
            re.sub(r"_[23]d$", "", group.split("/")[0].removeprefix(ARRAYS)) in ops]


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


def beside_robust(timed):
    """Every time of these programs, with how many times as long as robust it takes."""
    rows = [[group.replace("/", ", "), name, written(t.least(name) / 1e3), "" if name == "robust" else written(t.ratio(name, "robust"))]
            for group, t in timed.items() for name in sorted(t.of, key=lambda name: (name != "robust", name))]
    return table(["one call", "by", "us", "/ robust"], rows)


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


def circumstances(build):
    """The compiler, its flags and the kind of processor."""
    if not (build / "compile_commands.json").exists():
        sys.exit(f"{build} has no build; ./dev bench makes one")
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
    if not drawn:
        sys.exit("there are no times of arrays for the picture")
    file.write_text(drawn)


@dataclasses.dataclass
class Run:
    """The times that were measured there, {program: {group: Times}}; load at the start and repetitions of the worst part."""
    circumstances: str
    load: float
    repetitions: int
    timed: dict

    @classmethod
    def read(cls, file):
        try:
            run = cls(**json.loads(file.read_text()))
        except (OSError, ValueError, TypeError) as why:
            sys.exit(f"{file}: no times that --keep wrote: {why}")
        run.timed = {name: {group: Times(**times) for group, times in groups.items()} for name, groups in run.timed.items()}
        return run

    def write(self, file):
        file.write_text(json.dumps(vars(self), default=vars))


def measured(options):
    run = Run(circumstances(options.build), os.getloadavg()[0], options.repetitions, {})
    if options.keep and options.keep.exists():
        before = Run.read(options.keep)
        if before.circumstances != run.circumstances:
            sys.exit(f"{options.keep} was timed elsewhere: {before.circumstances}")
        run = Run(run.circumstances, max(run.load, before.load), min(run.repetitions, before.repetitions), before.timed)
    for name in options.programs:
        program = str(options.build / "bench" / name)
        timed = run.timed.setdefault(name, {})
        if options.ops and not pathlib.Path(program).exists():
            continue  # ./dev check builds only the program that has every operation
        for group in groups(program, options.ops):
            print(group, file=sys.stderr)
            timed[group] = Times().measure(program, group, options.repetitions)
        if name == "triangulation":
            add_earcut(program, timed)
        if options.keep:
            run.write(options.keep)
    if not any(run.timed.values()):
        sys.exit(f"{', '.join(options.ops)}: no program in {options.build / 'bench'} measures this")
    return run


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=ROOT / "build/bench")
    parser.add_argument("--ops", type=lambda text: text.split(","), default=[])
    parser.add_argument("--programs", type=lambda text: text.split(","), default=PROGRAMS)
    parser.add_argument("--repetitions", type=int, default=15)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--guard", action="store_true")
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("--picture", type=pathlib.Path)
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("--times", type=pathlib.Path)
    options = parser.parse_args()
    for name in set(options.programs) - set(PROGRAMS):
        parser.error(f"--programs: {name} is none of {', '.join(PROGRAMS)}")
    if options.repetitions < 1:
        parser.error("--repetitions: 1 or more")
    if options.times and (options.ops or options.keep or options.programs is not PROGRAMS):
        parser.error("--times measures nothing: --ops, --programs and --keep are not for it")
    for file in filter(None, (options.page, options.picture, options.keep)):  # before a long run
        if not file.resolve().parent.is_dir():
            parser.error(f"{file}: there is no such folder")
    run = Run.read(options.times) if options.times else measured(options)
    words, timed = run.circumstances, {name: {} for name in PROGRAMS} | run.timed
    decided = timed["operations"] | timed["polygons"]
    reached = goals(decided | timed["triangulation"] | timed["hulls"], timed["oracle"],
                    goals_of_pairs(timed["pairs"]))
    beside = timed["mesh_rays"] | timed["mesh_points"] | timed["distances"]
    parts = [words, reached, table_of_arrays(timed["arrays"]), decisions(decided), arrays(timed["arrays"]),
             "" if options.ops or options.times else arrays_from_python(options.build.resolve()), triangulations(timed["triangulation"]),
             hulls(timed["hulls"]), meshes(timed["meshes"]), prepared(timed["prepared"]), beside_robust(beside), pairs(timed["pairs"]),
             answers(timed["operations"]), truths(timed["oracle"]), exhausted(timed["oracle"])]
    report = "\n\n".join(str(part) for part in parts if part)
    print(report)
    if options.page:
        command = shlex.join(["bench/ratios.py", *sys.argv[1:]])
        options.page.write_text(page.page(words, command, run.repetitions, run.load, os.cpu_count(), timed, report))
        print(f"\npage: {options.page}")
    if options.picture:
        draw_picture(options.picture, words, timed)
    new = [part for part in parts if isinstance(part, tables.Table)]
    kept = tables.read(tables.DATA.read_text())
    if options.write:
        tables.keep(new, f"{words} {run.repetitions} repetitions.")
    if options.guard:
        lines, found = guard.said(kept, new)
        print("\n".join(["", f"now: {words}", *dict.fromkeys(f"kept: {table.measured}" for table in kept), *lines]))
        sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
