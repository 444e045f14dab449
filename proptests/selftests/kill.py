#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the property suite alone, the vectors alone and fuzzing alone kill the mutants: kill.py PROGRAMS VECTORS
MATRIX [--only OPERATION] [--share test|N/M]. Writes the matrix to the file MATRIX too. Exit code 1 if a mutant
survives, or if something cries wolf while no mutant is on."""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import time

from mutants import WAYS, chosen, listed

SECONDS = 60  # that fuzzing may take; it usually needs less than one
CALM = {"test": 1}  # and how long it has to stay silent without a mutant, by share,
CALM_OTHERWISE = 5


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
    """The three ways of asking. Each takes the numbers of an operation's mutants, in one process or in several, and
    returns (silent without a mutant, {number: seconds until it was killed}, seconds in all)."""

    def __init__(self, programs, vectors, calm):
        self.programs, self.vectors, self.calm = programs, vectors, calm

    def in_one(self, command, numbers, **environment):
        """A program that asks them all, in alive.h's way; a hang is its own affair."""
        code, seconds, told = run(command, TOUCHSTONE_MUTANTS=",".join(map(str, numbers)), **environment)
        killed = {int(number): float(taken) for number, taken in re.findall(r"^killed (\d+) ([\d.]+)$", told, re.M)}
        return code == 0, killed, seconds

    def properties(self, operation, numbers):
        return self.in_one([self.programs / "mutant_properties", f"{operation}:*"], numbers, TOUCHSTONE_CASES="4",
                           RC_PARAMS="noshrink=1")

    def by_vectors(self, operation, numbers):
        return self.in_one([self.programs / "mutant_vectors", self.vectors / f"{operation}.jsonl"], numbers)

    def fuzzing(self, operation, numbers):
        def ask(number):
            with tempfile.TemporaryDirectory() as folder:
                command = [self.programs / "mutant_fuzz", operation, "-seed=1", "-timeout=5",
                           f"-max_total_time={SECONDS if number else self.calm}", folder]
                code, seconds, _ = run(command, SECONDS + 20, folder, TOUCHSTONE_MUTANT=str(number))
            return code != 0, seconds

        asked = {number: ask(number) for number in [0, *numbers]}
        return (not asked[0][0], {number: seconds for number, (dead, seconds) in asked.items() if number and dead},
                sum(seconds for _, seconds in asked.values()))


def line(mutant, results):
    """results: {way: seconds until it was killed, or None}; a way that was not asked is not there."""
    def cell(way):
        return "-" if way not in results else "SURVIVED" if results[way] is None else f"{results[way]:.1f} s"
    return f"{mutant['id']:<26}" + "".join(f"{cell(way):>12}" for way in WAYS) + f"  {mutant['what']}"


def main(programs, vectors, matrix, only=None, share="all"):
    mutants = [(number, mutant) for number, mutant in listed() if only in (None, mutant["operation"])]
    if not mutants:
        sys.exit(f"no mutants of {only}")
    try:
        cells = chosen(mutants, share)
    except ValueError as error:
        sys.exit(f"--share {share}: {error}")
    killers = Killers(pathlib.Path(programs).resolve(), pathlib.Path(vectors), CALM.get(share, CALM_OTHERWISE))
    ways = dict(zip(WAYS, (killers.properties, killers.by_vectors, killers.fuzzing)))
    together = collections.defaultdict(list)  # what one process may ask
    for number, mutant, way in cells:
        together[mutant["operation"], way].append((number, mutant["id"]))
    results, seconds, wolf = collections.defaultdict(dict), collections.Counter(), set()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        running = {(operation, way): pool.submit(ways[way], operation, [number for number, _ in asked])
                   for (operation, way), asked in together.items()}
        for (operation, way), done in running.items():
            silent, dead, taken = done.result()
            seconds[operation] += taken
            if not silent:
                wolf.add(operation)
            for number, name in together[operation, way]:
                results[name][way] = dead.get(number)
    killed = sum(dead is not None for row in results.values() for dead in row.values())
    lines = ["mutants, and the time until each way alone killed them"]
    lines.append(f"{'':<26}" + "".join(f"{way:>12}" for way in WAYS))
    lines += [line(mutant, results[mutant["id"]]) for _, mutant in mutants if mutant["id"] in results]
    lines.append(f"{len(results)} of {len(mutants)} mutants, {killed} of {len(cells)} times killed; without a mutant: "
                 + ("all silent" if not wolf else "FALSE ALARM in " + ", ".join(sorted(wolf))))
    text = "\n".join(lines) + "\n"
    print(text)
    pathlib.Path(matrix).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(matrix).write_text(text)
    for operation, taken in sorted(seconds.items()):
        print(f"{taken:.3f} s: {operation}: mutants")
    return 1 if wolf or killed < len(cells) else 0


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("programs", "vectors", "matrix"):
        arguments.add_argument(name)
    arguments.add_argument("--only", metavar="OPERATION", help="the mutants of one operation")
    arguments.add_argument("--share", default="all", help="all; test: the third that ./dev test asks; N/M: a part")
    sys.exit(main(**vars(arguments.parse_args())))
