# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for solids and the half-space behind a plane, as in check_half_spaces.cpp."""

from certify_obbs import at, greatest, obb, reach
from certify_reading import WRONG_KIND, expect
from certify_space import ball, dot, plane, triple
from certify_triangles import capsule_in_space, weighted

KINDS_OF_BALLS = {"disjoint": "nearest_point", "touching": "tangent", "overlapping": "common_interior_point"}
KINDS_OF_BOXES = {"disjoint": "lowest_point", "touching": "lowest_point", "overlapping": "common_interior_point"}


def expect_ball_over_plane(claim, center, radius, level):
    """Why the point is the nearest one stands in check_half_spaces.cpp."""
    normal, offset = level
    point, kind = triple(claim, "point"), claim.kind()
    way = tuple(x - y for x, y in zip(center, point))
    height, along, beyond = dot(normal, point) + offset, dot(normal, way), dot(way, way) - radius**2
    if kind == "common_interior_point":
        expect(height < 0 and beyond < 0, "certificate: the point is not inside both")
        return
    nearest = height <= 0 <= along and along * height == 0 and along**2 == dot(way, way) * dot(normal, normal)
    expect(nearest, "certificate: a point of the half-space is nearer")
    if kind == "nearest_point":
        expect(beyond > 0, "certificate: the point is in the ball")
    else:
        expect(beyond == 0, "certificate: the point is not on the boundary of the ball")


def expect_contact_and_kind(claim, kinds):
    claim.answers("contact")
    contact = claim.word("contact")
    expect(contact in kinds, "truth: contact is wrong")
    expect(claim.kind() == kinds[contact], WRONG_KIND)


def check_sphere_plane(claim):
    claim.inputs("sphere", "plane")
    (center, radius), level = ball(claim.input["sphere"], "sphere"), plane(claim.input["plane"], "plane")
    expect_contact_and_kind(claim, KINDS_OF_BALLS)
    claim.facts("point")
    expect_ball_over_plane(claim, center, radius, level)


def check_capsule_plane(claim):
    claim.inputs("capsule", "plane")
    ends, radius = capsule_in_space(claim.input["capsule"], "capsule")
    level = plane(claim.input["plane"], "plane")
    expect_contact_and_kind(claim, KINDS_OF_BALLS)
    claim.facts("weights", "point")
    weights = claim.list("weights")
    expect(len(weights) == 2, "certificate: as many weights as points")
    lowest = weighted(ends, weights)
    higher = all(dot(level[0], end) >= dot(level[0], lowest) for end in ends)
    expect(higher, "certificate: a point of the segment is lower")
    expect_ball_over_plane(claim, lowest, radius, level)


def check_obb_plane(claim):
    claim.inputs("obb", "plane")
    box, (normal, offset) = obb(claim.input["obb"], "obb"), plane(claim.input["plane"], "plane")
    expect_contact_and_kind(claim, KINDS_OF_BOXES)
    claim.facts("coefficients")
    coefficients = claim.list("coefficients")
    growth, height = greatest(coefficients, "coefficients"), dot(normal, at(box, coefficients)) + offset
    if claim.kind() == "common_interior_point":
        expect(growth < 1, "certificate: the point is not inside the box")
        expect(height < 0, "certificate: the point is not behind the plane")
        return
    expect(growth <= 1, "certificate: the point is not in the box")
    expect(height + reach(box, normal) == dot(normal, box[0]) + offset, "certificate: a point of the box is lower")
    held = height > 0 if claim.word("contact") == "disjoint" else height == 0
    expect(held, "certificate: the height of the point proves another truth")
