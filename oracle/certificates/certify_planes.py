# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of points, polygons and planes in space: one function an operation, as in check_planes.cpp."""

from certify_reading import expect
from certify_rounding import expect_rounds_alike
from certify_space import dot, plane, point_in_space


def sign(value):
    return (value > 0) - (value < 0)


def expect_root(name, claimed, height, squared_length):
    held = sign(claimed) == sign(height) and claimed**2 * squared_length == height**2
    expect(held, f"truth: {name} is wrong")


def expect_root_enclosed(name, claimed, low, high, height, squared_length):
    inner, outer = (high, low) if height < 0 else (low, high)
    alike = height != 0 and sign(low) == sign(high) == sign(height) and low <= high
    held = alike and inner**2 * squared_length <= height**2 <= outer**2 * squared_length
    expect(held, f"certificate: the bounds of {name} are wrong")
    expect_rounds_alike(name, claimed, low, high)


def check_point_ground_plane(claim):
    claim.inputs("point"), claim.answers("side")
    p = point_in_space(claim.input["point"], "point")
    claim.expect_kind("height"), claim.facts("height")
    height = claim.single("height")
    expect(height == p[1], "certificate: the height is wrong")
    side = "below" if height < 0 else "above" if height > 0 else "on"
    expect(claim.word("side") == side, "truth: side is wrong")


def check_point_plane(claim):
    claim.inputs("plane", "point"), claim.answers("side", "signed_distance")
    normal, offset = plane(claim.input["plane"], "plane")
    p = point_in_space(claim.input["point"], "point")
    height, length = dot(normal, p) + offset, dot(normal, normal)
    side = "back" if height < 0 else "front" if height > 0 else "on"
    expect(claim.word("side") == side, "truth: side is wrong")
    distance = claim.exact("signed_distance")
    if claim.kind() == "enclosure":
        claim.facts("distance")
        expect_root_enclosed("signed_distance", distance, *claim.pair("distance"), height, length)
    else:
        claim.expect_kind("root"), claim.facts()
        expect_root("signed_distance", distance, height, length)
