#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Headers that users include stay short after preprocessing: an engine's main program, a predicate, a recorder.

  preprocessed.py COMPILER ROOT GENERATED   prints the lines of each and fails beyond a limit
"""
import subprocess
import sys

LIMITS = {
    "program/engine_main.h": 60_000,
    "robust/lines/orientation.h": 8_000,
    "c/record.h": 65_000,
}


def lines(compiler, root, generated, header):
    command = [compiler, "-std=c++20", f"-I{root}", f"-I{root}/c", f"-I{generated}", "-E", "-x", "c++", "-"]
    ran = subprocess.run(command, input=f'#include "{header}"\n', capture_output=True, text=True, check=True)
    return ran.stdout.count("\n")


def main():
    compiler, root, generated = sys.argv[1:]
    too_long = False
    for header, limit in LIMITS.items():
        found = lines(compiler, root, generated, header)
        print(f"{header}: {found:,} lines after preprocessing, at most {limit:,}")
        too_long = too_long or found > limit
    return 1 if too_long else 0


if __name__ == "__main__":
    sys.exit(main())
