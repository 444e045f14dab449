#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that an example of how to use the vectors finds what the vectors say that the textbook formula gets wrong:
vector_consumers.py VECTORS SOURCE COMMAND..."""
import json
import pathlib
import re
import subprocess
import sys

LONGEST = 40  # lines: it shows how little is needed
FORMULA = {"formula_rounds", "formula_wrong", "formula_inexact"}


def main(vectors, source, command):
    lines = pathlib.Path(source).read_text(encoding="utf-8").count("\n")
    if lines > LONGEST:
        sys.exit(f"{source}: {lines} lines, more than {LONGEST}")
    said = subprocess.run([*command, vectors], check=True, text=True, stdout=subprocess.PIPE).stdout
    wrong = set(re.findall(r'^"?([a-z_]+/[0-9a-f]+)\b', said, re.MULTILINE))
    for operation in ("orientation", "line_point_at"):
        with open(pathlib.Path(vectors) / f"{operation}.jsonl", encoding="utf-8") as file:
            answered = [vector for vector in map(json.loads, file) if "refused" not in vector]
        flagged = {vector["id"] for vector in answered if FORMULA & set(vector["flags"])}
        found = {name for name in wrong if name.startswith(operation + "/")}
        if f"{operation}: {len(answered)} asked, {len(found)} wrong\n" not in said:
            sys.exit(f"{operation}: no line '{len(answered)} asked, {len(found)} wrong' in:\n{said}")
        # Its formulas are the textbook's. Of numbers it compares the distance from the nearest double, not from the
        # truth, so that it may let pass what is a little more than two units off.
        if not found or found - flagged or (operation == "orientation" and flagged - found):
            sys.exit(f"{operation}: wrong are {sorted(found)}, flagged {sorted(flagged)}")


if __name__ == "__main__":
    main(sys.argv[1], sys.argv[2], sys.argv[3:])
