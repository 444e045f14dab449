#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks whether certify.py gives every claim the verdict, and the reason, that is written beside it.

usage: checkers_agree.py CLAIMS [VERDICTS]
CLAIMS: one claim a line. Line by line VERDICTS says what the C++ checker said ("accepted" or the reason); without it,
each claim's own field `refused` does. Files that claims name stand in the folder of CLAIMS.
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "oracle/certificates"))
import certify  # noqa: E402


def lines(path):
    return pathlib.Path(path).read_text(encoding="utf-8").removesuffix("\n").split("\n")


claims = lines(sys.argv[1])
if len(sys.argv) > 2:
    verdicts = lines(sys.argv[2])
else:
    verdicts = [json.loads(claim).get("refused", "accepted") for claim in claims]
wrong = 0
for position, (claim, expected) in enumerate(zip(claims, verdicts, strict=True), 1):
    said = certify.refuse(claim, pathlib.Path(sys.argv[1]).parent) or "accepted"
    if said != expected:
        wrong += 1
        print(f"{sys.argv[1]}:{position}: {said!r} instead of {expected!r}: {claim[:400]}")
sys.exit(1 if wrong or len(claims) < 20 else 0)
