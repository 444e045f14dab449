# SPDX-License-Identifier: Apache-2.0
"""The second truths of collision response, for simplest_truth.py: each takes an input as it stands in a claim and
gives the answer and the margin."""
from simplest_truth_reading import dot, number, point


def truth_reflect_wall(q):
    """Nothing is decided: there is no margin."""
    turned = {q["axis"]: -1}
    return {"velocity": [str(turned.get(axis, 1) * number(v)) for axis, v in zip("xyz", q["velocity"])]}, None


def written_velocity(v):
    return [str(x) for x in v]


def without_part(v, n, share):
    """v less so many times its part along n."""
    return tuple(x - share * dot(v, n) / dot(n, n) * y for x, y in zip(v, n))


def truth_reflect_plane(q):
    return {"velocity": written_velocity(without_part(point(q["velocity"]), point(q["normal"]), 2))}, None


def truth_damped_reflection(q):
    share = 1 + number(q["k"])
    return {"velocity": written_velocity(without_part(point(q["velocity"]), point(q["normal"]), share))}, None
