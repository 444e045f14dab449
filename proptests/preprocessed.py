#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Headers that users include stay short after preprocessing: an engine's main program, a predicate, a recorder. The
header of all shapes includes each header of geometry/ that declares one.

  preprocessed.py COMPILER ROOT GENERATED   prints the lines of each and fails beyond a limit
"""
import pathlib
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
    folder = pathlib.Path(root)
    all_shapes = (folder / "catalogue/shape/described_all.h").read_text(encoding="utf-8")
    declaring = [header.name for header in sorted((folder / "geometry").glob("*.h"))
                 if header.name != "members.h" and "auto members = as_" in header.read_text(encoding="utf-8")]
    missing = [name for name in declaring if f'"geometry/{name}"' not in all_shapes]
    for name in missing:
        print(f"catalogue/shape/described_all.h: does not include geometry/{name}")
    return 1 if too_long or missing else 0


if __name__ == "__main__":
    sys.exit(main())
