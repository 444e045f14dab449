#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Test vectors from Python: consumer.py VECTORS prints the id of every vector that a function below gets wrong."""
import json
import math
import pathlib
import sys


def orientation(p0, p1, p):
    cross = (p1[0] - p0[0]) * (p[1] - p0[1]) - (p1[1] - p0[1]) * (p[0] - p0[0])
    return {"side": "left" if cross > 0 else "right" if cross < 0 else "on"}


def line_point_at(line, t):
    return {"point": [o + t * d for o, d in zip(line["origin"], line["direction"])]}


def same(mine, right):
    """Words are equal; numbers are at most two units in the last place apart. "inf" is the double infinity."""
    if isinstance(right, dict):
        return mine.keys() == right.keys() and all(same(mine[name], right[name]) for name in right)
    if isinstance(right, list):
        return len(mine) == len(right) and all(map(same, mine, right))
    if isinstance(mine, float):
        right = float(right)
        return mine == right or abs(mine - right) <= 2 * math.ulp(right) < math.inf
    return mine == right


for function in (orientation, line_point_at):
    asked = wrong = 0
    for line in open(pathlib.Path(sys.argv[1]) / f"{function.__name__}.jsonl", encoding="utf-8"):
        vector = json.loads(line, parse_int=float)  # 1 is the double 1.0, not an integer
        if "refused" not in vector:  # outside the contract: what you do there is yours to say
            asked += 1
            if not same(function(**vector["input"]), vector["rounded"]):
                wrong += 1
                print(vector["id"], *vector["flags"])
    print(f"{function.__name__}: {asked} asked, {wrong} wrong")
