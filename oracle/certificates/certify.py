#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks certificates of geometric answers with fractions alone.

usage: certify.py [FILE...]    (standard input without a FILE, or where FILE is -)

Each line is one claim, {"op":..,"input":{..},"truth":{..},"certificate":{"kind":..,facts}}; other keys are ignored. Prints
every refused line with its reason and then "N certificates, M refused"; test vectors of refused inputs are only counted. Exit code: 0 all hold, 1 some refused, 2 a file
cannot be read. The same checks as the files check_*.cpp beside it, and the same reasons.
"""

import importlib
import json
import pathlib
import re
import sys

from certify_reading import Claim, Refusal, expect

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)

# Every function check_OPERATION of a file certify_*.py beside this one.
CHECKS = {
    name.removeprefix("check_"): check
    for path in sorted(pathlib.Path(__file__).resolve().parent.glob("certify_*.py"))
    for name, check in vars(importlib.import_module(path.stem)).items()
    if name.startswith("check_")
}


# A claim is nested five deep. What is nested without end may end a program that walks it.
MOST_NESTED = 64
STRING_OR_BRACKET = re.compile(r'"[^"\\]*(?:\\.[^"\\]*)*"?|[][{}]', re.DOTALL)


def nested_too_deep(text):
    depth = 0
    for found in STRING_OR_BRACKET.finditer(text):
        depth += {"[": 1, "{": 1, "]": -1, "}": -1}.get(found.group()[0], 0)
        if depth > MOST_NESTED:
            return True
    return False


def no_constant(name):
    raise ValueError(name)


def refuse(text):
    """Why the claim in one line of text is not accepted, or None."""
    if nested_too_deep(text):
        return f"claim: nested at most {MOST_NESTED} deep"
    try:
        line = json.loads(text, parse_constant=no_constant)
    except ValueError:
        return "not JSON"
    try:
        expect(isinstance(line, dict), "claim: an object")
        for name in ("op", "input", "truth", "certificate"):
            expect(name in line, f"claim: field {name} is missing")
        expect(isinstance(line["op"], str), "op: a string")
        expect(line["op"] in CHECKS, "op: not an operation with certificates")
        CHECKS[line["op"]](Claim(line))
    except Refusal as refusal:
        return str(refusal)
    return None


def is_refused_input(text):
    """Whether the line is a test vector of an input that is refused: there is nothing to certify."""
    if nested_too_deep(text):
        return False
    try:
        line = json.loads(text)
    except ValueError:
        return False
    return isinstance(line, dict) and "refused" in line and "truth" not in line and "certificate" not in line


def main(paths):
    total = refused = without = 0
    for path in paths or ["-"]:
        try:
            stream = sys.stdin.buffer if path == "-" else open(path, "rb")
        except OSError as error:
            print(f"{path}: {error.strerror}", file=sys.stderr)
            return 2
        with stream:
            for position, raw in enumerate(stream, 1):
                if not raw.strip():
                    continue
                try:
                    text = raw.decode("utf-8")
                except UnicodeDecodeError:
                    text = ""
                if is_refused_input(text):
                    without += 1
                    continue
                total += 1
                reason = refuse(text)
                if reason is not None:
                    refused += 1
                    print(f"{path}:{position}: {reason}")
    counted = f"; {without} refused inputs, which have none" if without else ""
    print(f"{total} certificates, {refused} refused{counted}")
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
