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
import shutil
import subprocess
import sys
import tempfile
import time

from mutants import WAYS, chosen, listed

SECONDS = 60  # that fuzzing may take; it usually needs less than one
CALM = {"test": 2}  # and how long it has to stay silent without a mutant, by share,
CALM_OTHERWISE = 5
LONGEST = 600  # of the other ways, without a mutant


def run(command, mutant, limit, cwd=None):
    """(exit code or None after `limit` seconds, seconds)"""
    started = time.monotonic()
    environment = dict(os.environ, TOUCHSTONE_MUTANT=str(mutant), TOUCHSTONE_CASES="4")
    try:
        code = subprocess.run(command, env=environment, cwd=cwd, timeout=limit, capture_output=True).returncode
    except subprocess.TimeoutExpired:
        code = None
    return code, time.monotonic() - started


class Killers:
    """The three ways of asking; each returns (killed, seconds). A crash or a hang kills too: `limit` is what the way
    took without a mutant, and much more."""

    def __init__(self, programs, vectors, calm):
        self.programs, self.vectors, self.calm = programs, vectors, calm

    def properties(self, operation, mutant, limit):
        code, seconds = run([self.programs / "mutant_properties", f"{operation}:*", "--abort"], mutant, limit)
        return code != 0, seconds

    def by_vectors(self, operation, mutant, limit):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(self.vectors / f"{operation}.jsonl", folder)
            code, seconds = run([self.programs / "mutant_vectors", "vectors", "check", folder], mutant, limit)
        return code != 0, seconds

    def fuzzing(self, operation, mutant, _):
        of_all = self.programs / "mutant_fuzz"  # one program for all operations, or one for each
        program = [of_all, operation] if of_all.exists() else [self.programs / f"mutant_fuzz_{operation}"]
        with tempfile.TemporaryDirectory() as folder:
            command = [*program, "-seed=1", f"-max_total_time={SECONDS if mutant else self.calm}", "-timeout=5", folder]
            code, seconds = run(command, mutant, SECONDS + 20, cwd=folder)
        return code != 0, seconds


def line(mutant, results):
    """results: {way: (killed, seconds)}; a way that was not asked is not there."""
    cells = ""
    for way in WAYS:
        killed, seconds = results.get(way, (None, 0))
        cells += f"{'-' if killed is None else f'{seconds:.1f} s' if killed else 'SURVIVED':>12}"
    return f"{mutant['id']:<26}{cells}  {mutant['what']}"


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
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        calm = {}
        for _, mutant, way in cells:
            asked = mutant["operation"], way
            if asked not in calm:
                calm[asked] = pool.submit(ways[way], mutant["operation"], 0, LONGEST)

        def with_mutant(operation, number, way):
            return ways[way](operation, number, 5 + 3 * calm[operation, way].result()[1])

        running = [pool.submit(with_mutant, mutant["operation"], number, way) for number, mutant, way in cells]
        results, seconds = collections.defaultdict(dict), collections.Counter()
        for (_, mutant, way), done in zip(cells, running):
            results[mutant["id"]][way] = done.result()
            seconds[mutant["operation"]] += done.result()[1]
        for (operation, _), done in calm.items():
            seconds[operation] += done.result()[1]
        wolf = sorted({operation for (operation, _), done in calm.items() if done.result()[0]})
    killed = sum(dead for row in results.values() for dead, _ in row.values())
    lines = ["mutants, and the time until each way alone killed them"]
    lines.append(f"{'':<26}" + "".join(f"{way:>12}" for way in WAYS))
    lines += [line(mutant, results[mutant["id"]]) for _, mutant in mutants if mutant["id"] in results]
    lines.append(f"{len(results)} of {len(mutants)} mutants, {killed} of {len(cells)} times killed; without a mutant: "
                 + ("all silent" if not wolf else "FALSE ALARM in " + ", ".join(wolf)))
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
