#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tests that the property suite alone, the vectors alone and fuzzing alone kill the mutants.

Writes the time of each kill to the file MATRIX, and prints it; the last line names the survivors. Exit code 1 if a
mutant survives, or on a false alarm: a way finds something in the baseline, which has no mutant. From the property
suite it runs what compares robust with the oracle, and arrays with single questions (agreement/interrogation.cpp,
refusals.cpp, arrays.cpp)."""
import argparse
import collections
import concurrent.futures
import fractions
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from mutants import WAYS, chosen, listed

SECONDS = 150  # that fuzzing may take; it usually needs less than one
BASELINE = {"test": 1}  # how long fuzzing runs the baseline, by share, in seconds,
BASELINE_OTHERWISE = 5


ROWS = pathlib.Path(__file__).resolve().parents[2] / "catalogue/rows"


def question_of(operation):
    """The operation whose question it answers: itself, unless it is another implementation."""
    row = next(ROWS.glob(f"*/{operation}.h"), None)
    found = re.search(r'(\w+)::metadata\.implementation\(', row.read_text(encoding="utf-8")) if row else None
    return found.group(1) if found else operation


def run(command, limit=None, cwd=None, **environment):
    """(exit code or None after `limit` seconds, seconds, standard output)"""
    started = time.monotonic()
    try:
        done = subprocess.run(command, env=os.environ | environment, cwd=cwd, timeout=limit, text=True,
                              stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    except subprocess.TimeoutExpired:
        return None, time.monotonic() - started, ""
    return done.returncode, time.monotonic() - started, done.stdout


class Killers:
    """One function for each way. It takes the numbers of an operation's mutants and returns (whether the baseline
    passes, {number: seconds until it was killed}, seconds in all)."""

    def __init__(self, programs, vectors, cases, baseline):
        self.programs, self.vectors, self.cases, self.baseline = programs, vectors, cases, baseline

    def in_one(self, command, numbers, **environment):
        """By a program that runs them all as surviving.h says, hanging mutants too."""
        code, seconds, output = run(command, TOUCHSTONE_MUTANTS=",".join(map(str, numbers)), **environment)
        killed = {int(number): float(taken) for number, taken in re.findall(r"^killed (\d+) ([\d.]+)$", output, re.M)}
        return code == 0, killed, seconds

    def properties(self, operation, numbers):
        return self.in_one([self.programs / "mutant_properties", f"{operation}:*"], numbers,
                           TOUCHSTONE_CASES=str(float(self.cases)), RC_PARAMS="noshrink=1")

    def by_vectors(self, operation, numbers):
        question = question_of(operation)
        with tempfile.TemporaryDirectory() as folder:
            vectors = self.vectors / f"{question}.jsonl"
            if question != operation:  # another implementation is asked what the operation is asked
                text = vectors.read_text(encoding="utf-8").replace(f'"op":"{question}"', f'"op":"{operation}"')
                vectors = pathlib.Path(folder, vectors.name)
                vectors.write_text(text, encoding="utf-8")
            return self.in_one([self.programs / "mutant_vectors", vectors], numbers)

    def fuzzing(self, operation, numbers):
        def fuzz(number):
            with tempfile.TemporaryDirectory() as folder:
                command = [self.programs / "mutant_fuzz", operation, "-seed=1", "-timeout=5",
                           f"-max_total_time={SECONDS if number else self.baseline}", folder]
                code, seconds, _ = run(command, SECONDS + 20, folder, TOUCHSTONE_MUTANT=str(number))
            return code != 0, seconds

        done = {number: fuzz(number) for number in [0, *numbers]}
        return (not done[0][0], {number: seconds for number, (dead, seconds) in done.items() if number and dead},
                sum(seconds for _, seconds in done.values()))


def line(mutant, results):
    """results: {way: seconds until it was killed, or None}; a way that was not run is not there."""
    def cell(way):
        return "-" if way not in results else "SURVIVED" if results[way] is None else f"{results[way]:.1f} s"
    return f"{mutant['id']:<26}" + "".join(f"{cell(way):>12}" for way in WAYS) + f"  {mutant['what']}"


def summary(mutants, results, ways, false_alarms):
    """One line: by way how many were killed, then who survived, and whether the baseline passes."""
    counts = []
    for way in ways:
        cells = [row[way] for row in results.values() if way in row]
        counts.append(f"{way} {sum(cell is not None for cell in cells)} of {len(cells)}")
    survivors = [f"{name} ({', '.join(way for way in ways if row.get(way, 0) is None)})"
                 for name, row in results.items() if None in row.values()]
    return (f"{len(results)} of {len(mutants)} mutants, killed by {', '.join(counts)}; survivors: "
            f"{', '.join(survivors) or 'none'}; false alarms: {', '.join(sorted(false_alarms)) or 'none'}")


def main(programs, vectors, matrix, only, share, ways, cases, brief):
    mutants = [(number, mutant) for number, mutant in listed() if only in (None, mutant["operation"])]
    if not mutants:
        sys.exit(f"no mutants of {only}")
    try:
        cells = chosen(mutants, share, ways)
    except ValueError as error:
        sys.exit(f"--share {share}: {error}")
    killers = Killers(pathlib.Path(programs).resolve(), pathlib.Path(vectors), cases,
                      BASELINE.get(share, BASELINE_OTHERWISE))
    functions = dict(zip(WAYS, (killers.properties, killers.by_vectors, killers.fuzzing)))
    together = collections.defaultdict(list)  # what one process may run
    for number, mutant, way in cells:
        together[mutant["operation"], way].append((number, mutant["id"]))
    results, seconds, false_alarms = collections.defaultdict(dict), collections.Counter(), set()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        running = {(operation, way): pool.submit(functions[way], operation, [number for number, _ in run_together])
                   for (operation, way), run_together in together.items()}
        for (operation, way), done in running.items():
            baseline_passes, dead, taken = done.result()
            seconds[operation] += taken
            if not baseline_passes:
                false_alarms.add(f"{operation} ({way})")
            for number, name in together[operation, way]:
                results[name][way] = dead.get(number)
    lines = ["mutants, and the time until each way alone killed them"]
    lines.append(f"{'':<26}" + "".join(f"{way:>12}" for way in WAYS))
    lines += [line(mutant, results[mutant["id"]]) for _, mutant in mutants if mutant["id"] in results]
    lines.append(summary(mutants, results, ways, false_alarms))
    text = "\n".join(lines) + "\n"
    pathlib.Path(matrix).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(matrix).write_text(text)
    if not brief:
        for operation, taken in sorted(seconds.items()):
            print(f"{taken:.3f} s: {operation}: mutants")
    print(lines[-1] if brief else text, end="\n" if brief else "")
    return 1 if false_alarms or any(None in row.values() for row in results.values()) else 0


def ways_of(text):
    ways = text.split(",")
    if not set(ways) <= set(WAYS):
        raise argparse.ArgumentTypeError(f"some of {','.join(WAYS)}")
    return tuple(way for way in WAYS if way in ways)


def factor(text):
    value = fractions.Fraction(text)
    if value <= 0:
        raise ValueError
    return value


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("programs", "vectors", "matrix"):
        arguments.add_argument(name)
    arguments.add_argument("--only", metavar="OPERATION", help="the mutants of one operation")
    arguments.add_argument("--share", default="all", help="all; test: the third that ./dev test full runs; N/M: a part")
    arguments.add_argument("--ways", default=WAYS, type=ways_of, help=f"some of {','.join(WAYS)}; all unless given")
    arguments.add_argument("--cases", default=1, type=factor, metavar="F",
                           help="F times as many cases of each property as the suite runs: 1 unless given, 1/8, 0.5")
    arguments.add_argument("--brief", action="store_true", help="print the last line alone")
    sys.exit(main(**vars(arguments.parse_args())))
