#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks certificates of geometric answers with fractions alone.

usage: certify.py [FILE...]    (standard input without a FILE, or where FILE is -)

Each line is one claim, {"op":..,"input":{..},"truth":{..},"certificate":{"kind":..,facts}}; other keys are ignored. Prints
every refused line with its reason and then "N certificates, M refused". Exit code: 0 all hold, 1 some refused, 2 a file
cannot be read. The same checks as the files check_*.cpp beside it, and the same reasons.
"""

import json
import sys

import certify_circle
import certify_convexity
import certify_lines
import certify_planes
from certify_reading import Claim, Refusal, expect

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)

CHECKS = {
    name.removeprefix("check_"): check
    for module in (certify_lines, certify_circle, certify_convexity, certify_planes)
    for name, check in vars(module).items()
    if name.startswith("check_")
}


def no_constant(name):
    raise ValueError(name)


def refuse(text):
    """Why the claim in one line of text is not accepted, or None."""
    try:
        line = json.loads(text, parse_constant=no_constant)
    except (ValueError, RecursionError):
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


def main(paths):
    total = refused = 0
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
                total += 1
                try:
                    reason = refuse(raw.decode("utf-8"))
                except UnicodeDecodeError:
                    reason = "not JSON"
                if reason is not None:
                    refused += 1
                    print(f"{path}:{position}: {reason}")
    print(f"{total} certificates, {refused} refused")
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
