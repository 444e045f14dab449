# SPDX-License-Identifier: Apache-2.0
"""The second truths of volumes of intervals around points, boxes and k-DOPs, for simplest_truth.py: each takes an input
as it stands in a claim and gives the answer and the margin."""
from simplest_truth_reading import point


def truth_aabb_of_points(q):
    """On each axis the number of which no other is less, and that of which none is greater: every one against all."""
    axes = list(zip(*map(point, q["points"])))
    low = [next(x for x in numbers if all(x <= y for y in numbers)) for numbers in axes]
    high = [next(x for x in numbers if all(x >= y for y in numbers)) for numbers in axes]
    return {"aabb": {"min": list(map(str, low)), "max": list(map(str, high))}}, None
