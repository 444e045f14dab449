# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of points, polygons and planes in space: one function an operation, as in check_planes.cpp."""

from certify_reading import expect
from certify_space import point_in_space


def check_point_ground_plane(claim):
    claim.inputs("point"), claim.answers("side")
    p = point_in_space(claim.input["point"], "point")
    claim.expect_kind("height"), claim.facts("height")
    height = claim.single("height")
    expect(height == p[1], "certificate: the height is wrong")
    side = "below" if height < 0 else "above" if height > 0 else "on"
    expect(claim.word("side") == side, "truth: side is wrong")
