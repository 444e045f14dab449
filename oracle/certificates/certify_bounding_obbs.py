# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for oriented boxes around points, as in check_bounding_obbs.cpp."""

from certify_reading import expect, only
from certify_space import dot, exact_triple, list_of_three, named, points_in_space
from certify_sums import over_one


def check_obb_of_points(claim):
    """Why that proves it stands in check_bounding_obbs.cpp."""
    claim.inputs("points")
    points = points_in_space(claim.input["points"], "points")
    claim.answers("obb")
    obb, name = claim.truth["obb"], "truth.obb.half_axes"
    only(obb, "truth.obb", ["center", "half_axes"])
    center = exact_triple(obb["center"], "truth.obb.center")
    axes = [exact_triple(axis, f"{name}[{k}]") for k, axis in enumerate(list_of_three(obb["half_axes"], name))]
    for k in range(3):
        expect(dot(axes[k], axes[k - 1]) == 0, "truth: the half axes are not at right angles")
    claim.expect_kind("touched_faces"), claim.facts("least", "most")
    proper, ends = [over_one(axis) for axis in axes if any(axis)], {}
    for fact in ("least", "most"):
        ends[fact] = named(claim, fact, points)
        expect(len(ends[fact]) == len(proper), f"certificate.{fact}: a place for each half axis that is not 0")

    middle, scale = over_one(center)
    squares = [dot(axis, axis) for axis, _ in proper]

    def from_middle(p):
        return [x * scale - y for x, y in zip(p, middle)]

    def ratio(p, k):
        """Returns the ratio of p's coordinate along a half axis to the half axis, as numerator and denominator."""
        axis, d = proper[k]
        return dot(from_middle(p), axis) * d, squares[k] * scale

    for p in points:
        for k in range(len(proper)):
            along, whole = ratio(p, k)
            expect(abs(along) <= whole, "truth: a point is outside of the box")
        left = from_middle(p)
        for (axis, _), square in zip(proper, squares):
            along = dot(left, axis)
            left = [x * square - along * y for x, y in zip(left, axis)]
        expect(not any(left), "truth: a point is outside of the box")
    for k, (low, high) in enumerate(zip(ends["least"], ends["most"])):
        (lowest, whole), (highest, _) = ratio(low, k), ratio(high, k)
        expect(-lowest == whole == highest, "certificate: a point is not on the face")
