#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""An engine that makes the steps of a scene: particles and balls between walls (docs/simulate.md).

build/release/touchstone simulate simulate/scenes/bouncing_ball.json --engine "python3 examples/simulate_engine.py"
"""
import json
import sys


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def step(scene):
    """Velocity first, then the position; a ball that is in a wall then, and flies on into it, is turned."""
    contacts, h = [], scene["timestep"]
    for i, body in enumerate(scene["bodies"]):
        if body["fixed"]:
            continue
        body["velocity"] = [v + h * g for v, g in zip(body["velocity"], scene["gravity"])]
        body["position"] = [p + h * v for p, v in zip(body["position"], body["velocity"])]
        for w, wall in enumerate(scene["walls"]):
            n = wall["normal"]
            length, speed = dot(n, n) ** 0.5, dot(n, body["velocity"])
            if dot(n, body["position"]) + wall["offset"] <= body.get("radius", 0) * length and speed < 0:
                turned = (1 + scene["restitution"]) * speed / dot(n, n)
                body["velocity"] = [v - turned * x for v, x in zip(body["velocity"], n)]
                contacts.append({"body": i, "wall": w})
    return {"bodies": [b["position"] + b["velocity"] for b in scene["bodies"]], "contacts": contacts}


def say(line):
    print(json.dumps(line), flush=True)


scene = json.loads(sys.stdin.readline())["scene"]
say({"engine": "ball in Python", "cannot": ["boxes", "stick", "penalty"],
     "thresholds": ["balls do not meet one another"]})
for line in sys.stdin:
    say({"step": json.loads(line)["step"], **step(scene)})
