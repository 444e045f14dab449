#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A crowd of 1,000 people in a yard, over numpy. It records what it asks its own test of points in polygons, which is right
but for the fence itself: of some sides a point is inside, of others outside.

  crowd.py LOG [STEPS]       with touchstone installed, or in its source tree
"""
import pathlib
import sys

import numpy

try:
    from touchstone.record import Recording, recorded
except ImportError:
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "python/touchstone"))
    from record import Recording, recorded

FENCE = numpy.array([[0, 0], [12, 0], [12, 8], [6, 4], [0, 8]], float)


@recorded("point_in_polygon", rows=True)
def inside(polygon, point):
    """Even or odd: one bool for each row of both."""
    odd = numpy.zeros(len(point), bool)
    x, y = point.T
    for i in range(polygon.shape[1]):
        (ax, ay), (bx, by) = polygon[:, i - 1].T, polygon[:, i].T
        with numpy.errstate(divide="ignore", invalid="ignore"):
            odd ^= ((ay > y) != (by > y)) & (x < ax + (y - ay) / (by - ay) * (bx - ax))
    return odd


def walk(steps):
    random = numpy.random.default_rng(1)
    people = random.integers(0, 48, (1000, 2)) / 4
    for _ in range(steps):
        step = random.integers(-1, 2, people.shape) / 4
        there = inside(numpy.broadcast_to(FENCE, (len(people), *FENCE.shape)), people + step)
        people[there] += step[there]
    return people


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    with Recording(sys.argv[1], engine="crowd 1.0", boundary="closed", one_in=10):
        walk(int(sys.argv[2]) if len(sys.argv) > 2 else 100)
