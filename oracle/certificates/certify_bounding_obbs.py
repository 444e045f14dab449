# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of oriented boxes around points, as in check_bounding_obbs.cpp."""

from certify_reading import expect, only
from certify_space import dot, exact_triple, list_of_three, named, points_in_space


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
    proper, ends = list(filter(any, axes)), {}
    for fact in ("least", "most"):
        ends[fact] = named(claim, fact, points)
        expect(len(ends[fact]) == len(proper), f"certificate.{fact}: a place for each half axis that is not 0")

    def coefficient(p, axis):
        return dot([x - y for x, y in zip(p, center)], axis) / dot(axis, axis)

    for p in points:
        left = [x - y for x, y in zip(p, center)]
        for axis in proper:
            t = coefficient(p, axis)
            expect(abs(t) <= 1, "truth: a point is outside of the box")
            left = [x - t * y for x, y in zip(left, axis)]
        expect(not any(left), "truth: a point is outside of the box")
    for axis, low, high in zip(proper, ends["least"], ends["most"]):
        touched = coefficient(low, axis) == -1 and coefficient(high, axis) == 1
        expect(touched, "certificate: a point is not on the face")
