#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the property suite alone, the vectors alone and fuzzing alone notice each planted bug: notice.py PROGRAMS
VECTORS MATRIX [--only OPERATION]. Writes the matrix to the file MATRIX too. Exit code 1 if a bug is missed, or if something
cries wolf while no bug is on."""
import argparse
import concurrent.futures
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

from planted import listed

SECONDS = 60  # that fuzzing may take; it usually needs less than one
CALM = 5  # and how long it has to stay silent without a bug
LONGEST = 600  # of the other ways, without a bug


def run(command, bug, limit, cwd=None):
    """(exit code or None after `limit` seconds, stderr, seconds)"""
    started = time.monotonic()
    environment = dict(os.environ, TOUCHSTONE_PLANTED=str(bug), TOUCHSTONE_CASES="1")
    try:
        done = subprocess.run(command, env=environment, cwd=cwd, timeout=limit, capture_output=True, text=True, errors="replace")
        code, said = done.returncode, done.stderr
    except subprocess.TimeoutExpired:
        code, said = None, ""
    return code, said, time.monotonic() - started


class Notice:
    """The three ways of asking; each returns (noticed, seconds). A crash or a hang is noticed too: `limit` is what the way took without a
    bug, and much more."""

    def __init__(self, programs, vectors):
        self.programs, self.vectors = programs, vectors

    def properties(self, operation, bug, limit):
        code, _, seconds = run([self.programs / "planted_properties", f"{operation}:*", "--abort"], bug, limit)
        return code != 0, seconds

    def by_vectors(self, operation, bug, limit):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(self.vectors / f"{operation}.jsonl", folder)
            code, _, seconds = run([self.programs / "planted_vectors", "vectors", "check", folder], bug, limit)
        return code != 0, seconds

    def fuzzing(self, operation, bug, _):
        with tempfile.TemporaryDirectory() as folder:
            command = [self.programs / f"planted_fuzz_{operation}", "-seed=1", f"-max_total_time={SECONDS if bug else CALM}",
                       "-timeout=5", folder]
            code, _, seconds = run(command, bug, SECONDS + 20, cwd=folder)
        return code != 0, seconds


WAYS = ("properties", "vectors", "fuzzing")


def line(bug, results):
    cells = "".join(f"{('%.1f s' % seconds if noticed else 'MISSED'):>12}" for noticed, seconds in results)
    return f"{bug['id']:<26}{cells}  {bug['what']}"


def main(programs, vectors, matrix, only=None):
    bugs = [(number, bug) for number, bug in listed() if only in (None, bug["operation"])]
    if not bugs:
        sys.exit(f"no planted bugs of {only}")
    notice = Notice(pathlib.Path(programs).resolve(), pathlib.Path(vectors))
    ways = (notice.properties, notice.by_vectors, notice.fuzzing)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        operations = sorted({bug["operation"] for _, bug in bugs})
        calm = {op: [pool.submit(way, op, 0, LONGEST) for way in ways] for op in operations}

        def with_bug(place, operation, number):
            return ways[place](operation, number, 5 + 3 * calm[operation][place].result()[1])

        found = [[pool.submit(with_bug, place, bug["operation"], number) for place in range(len(ways))] for number, bug in bugs]
        lines = [f"planted bugs, and the time until each way alone noticed them\n"
                 f"{'':<26}" + "".join(f"{way:>12}" for way in WAYS)]
        rows = [[cell.result() for cell in row] for row in found]
        lines += [line(bug, row) for (_, bug), row in zip(bugs, rows)]
        wolf = [op for op in operations if any(cell.result()[0] for cell in calm[op])]
    noticed = sum(seen for row in rows for seen, _ in row)
    lines.append(f"{len(bugs)} bugs, {noticed} of {3 * len(bugs)} times noticed; without a bug: "
                 + ("all silent" if not wolf else "FALSE ALARM in " + ", ".join(wolf)))
    text = "\n".join(lines) + "\n"
    print(text)
    pathlib.Path(matrix).parent.mkdir(parents=True, exist_ok=True)
    pathlib.Path(matrix).write_text(text)
    return 1 if wolf or noticed < 3 * len(bugs) else 0


if __name__ == "__main__":
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("programs", "vectors", "matrix"):
        arguments.add_argument(name)
    arguments.add_argument("--only", metavar="OPERATION", help="the bugs of one operation")
    sys.exit(main(**vars(arguments.parse_args())))
