# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of volumes of intervals around points, boxes and k-DOPs, as in check_kdops.cpp."""

from certify_reading import exact_value, expect, number, only


def points(value, what):
    """Of one dimension, two or three; at least one."""
    expect(isinstance(value, list) and value, what + ": at least 1 point")
    found = []
    for i, written in enumerate(value):
        each = f"{what}[{i}]"
        expect(isinstance(written, list) and len(written) in (2, 3), each + ": a list of two or three")
        found.append([number(coordinate, f"{each}[{axis}]") for axis, coordinate in enumerate(written)])
        expect(len(found[-1]) == len(found[0]), each + ": as many coordinates as the first")
    return found


def place(index, size, of_what):
    expect(index.denominator == 1 and 0 <= index < size, f"certificate: no {of_what} has this place")
    return int(index)


def exact_values(value, what, size):
    expect(isinstance(value, list) and len(value) == size, f"{what}: a list of {'two' if size == 2 else 'three'}")
    return [exact_value(each, f"{what}[{i}]") for i, each in enumerate(value)]


def check_aabb_of_points(claim):
    claim.inputs("points")
    everything = points(claim.input["points"], "points")
    axes = len(everything[0])
    claim.answers("aabb")
    box = claim.truth["aabb"]
    only(box, "truth.aabb", ("min", "max"))
    low = exact_values(box["min"], "truth.aabb.min", axes)
    high = exact_values(box["max"], "truth.aabb.max", axes)
    claim.expect_kind("extreme_points"), claim.facts("least", "greatest")
    least, greatest = claim.list("least"), claim.list("greatest")
    expect(len(least) == len(greatest) == axes, "certificate: two places for each axis")
    for k in range(axes):
        first = everything[place(least[k], len(everything), "point")][k]
        last = everything[place(greatest[k], len(everything), "point")][k]
        expect(first == low[k] and last == high[k], "certificate: the point has another coordinate")
        expect(all(low[k] <= p[k] <= high[k] for p in everything), "truth: a point is not in the box")
