# SPDX-License-Identifier: Apache-2.0
"""The second truths of collision response, for simplest_truth.py: each takes an input as it stands in a claim and
gives the answer and the margin."""
from simplest_truth_reading import number


def truth_reflect_wall(q):
    """Nothing is decided: there is no margin."""
    turned = {q["axis"]: -1}
    return {"velocity": [str(turned.get(axis, 1) * number(v)) for axis, v in zip("xyz", q["velocity"])]}, None
