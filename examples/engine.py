#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An engine in Python: touchstone audit --engine "python3 examples/engine.py" """
import json
import sys


def side(p, q, r):
    return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])


def orientation(p0, p1, p):
    s = side(p0, p1, p)
    return {"side": "left" if s > 0 else "right" if s < 0 else "on"}


def segment_segment(a, b):  # a plain answer to "do they meet?"
    return side(*a, b[0]) * side(*a, b[1]) <= 0 and side(*b, a[0]) * side(*b, a[1]) <= 0


operations = {"orientation": orientation, "segment_segment": segment_segment}


def say(line):
    print(json.dumps(line), flush=True)


sys.stdin.readline()
say({"engine": "textbook in Python", "ops": list(operations), "boundary": "closed"})
for line in sys.stdin:
    question = json.loads(line, parse_int=float)  # 1 is the double 1.0, not an integer
    try:
        say({"id": question["id"], "answer": operations[question["op"]](**question["input"])})
    except ArithmeticError as error:  # 1e200 ** 2 raises; without this it would end the engine
        say({"id": question["id"], "error": str(error)})
