# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of shapes of two chapters: one function an operation, as in check_mixed.cpp."""

from certify_reading import WRONG_KIND, expect
from certify_space import ball, dot, plane, triple

KINDS = {"disjoint": "nearest_point", "touching": "tangent", "overlapping": "common_interior_point"}


def check_sphere_plane(claim):
    """Why the point is the nearest one stands in check_mixed.cpp."""
    claim.inputs("sphere", "plane")
    center, radius = ball(claim.input["sphere"], "sphere")
    normal, offset = plane(claim.input["plane"], "plane")
    claim.answers("contact")
    contact, kind = claim.word("contact"), claim.kind()
    expect(contact in KINDS, "truth: contact is wrong")
    expect(kind == KINDS[contact], WRONG_KIND)
    claim.facts("point")
    point = triple(claim, "point")
    way = tuple(x - y for x, y in zip(center, point))
    height, along, beyond = dot(normal, point) + offset, dot(normal, way), dot(way, way) - radius**2
    if contact == "overlapping":
        expect(height < 0 and beyond < 0, "certificate: the point is not inside both")
        return
    nearest = height <= 0 <= along and along * height == 0 and along**2 == dot(way, way) * dot(normal, normal)
    expect(nearest, "certificate: a point of the half-space is nearer")
    if contact == "disjoint":
        expect(beyond > 0, "certificate: the point is in the ball")
    else:
        expect(beyond == 0, "certificate: the point is not on the boundary of the ball")
