#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Out of memory, `touchstone ask` loses one line: it is refused, and the others are answered.

Equal boxes all meet, and the certificate has a point for each pair: their number exceeds any memory that the address
space is limited to. Few and many queries of many boxes fit into it.
"""
import argparse
import json
import resource
import subprocess
import sys

LIMIT = 400 << 20  # bytes of address space
BOX = {"min": [0, 0, 0], "max": [1, 1, 1]}


def ask(program, operation, *questions):
    limits = lambda: resource.setrlimit(resource.RLIMIT_AS, (LIMIT, LIMIT))  # noqa: E731
    lines = "".join(json.dumps(question) + "\n" for question in questions)
    asked = subprocess.run([program, "ask", operation], input=lines, capture_output=True, text=True, preexec_fn=limits)
    return asked.returncode, [json.loads(line) for line in asked.stdout.splitlines()], asked.stderr.splitlines()


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    program = parser.parse_args().program
    wrong = []

    few, many = {"boxes": [BOX] * 2}, {"boxes": [BOX] * 1500}
    code, answers, complaints = ask(program, "all_pairs", few, many, few)
    error, pair = {"field": "line", "rule": "out of memory"}, {"pairs": [[0, 1]]}
    if [answer.get("truth", answer.get("error")) for answer in answers] != [pair, error, pair]:
        wrong.append(f"expected that one line is refused: {[list(answer) for answer in answers]}")
    if code != 2 or len(complaints) != 1 or not complaints[0].endswith("line 2: line: out of memory"):
        wrong.append(f"exit code {code}, {complaints}")

    # A kilobyte for each pair of a body and a query would be 3 GB.
    side = range(0, 30, 2)
    boxes = [{"min": [x, y, z], "max": [x + 1, y + 1, z + 1]} for x in side for y in side for z in side]
    points = [{"at_point": [i % 30, i % 29, i % 28]} for i in range(1000)]
    code, answers, complaints = ask(program, "broad_phase", {"boxes": boxes, "commands": points})
    if code != 0 or len(answers[0].get("truth", {}).get("replies", [])) != len(points):
        wrong.append(f"queries of {len(boxes)} boxes: exit code {code}, {complaints}")

    print("\n".join(wrong))
    return 1 if wrong else 0


sys.exit(main())
