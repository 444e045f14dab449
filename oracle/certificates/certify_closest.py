# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of nearest points, and of the contacts that follow from them, as in check_closest.cpp."""

from certify_reading import WRONG_KIND, expect
from certify_space import box_holds, box_in_space, dot, plane, triple


def is_lowest(low, high, slopes, x):
    """Why that is so stands in check_closest.cpp."""
    return all(not (n > 0 and y != a) and not (n < 0 and y != b) for a, b, n, y in zip(low, high, slopes, x))


def check_aabb_plane(claim):
    claim.inputs("aabb", "plane")
    (low, high), (normal, offset) = box_in_space(claim.input["aabb"], "aabb"), plane(claim.input["plane"], "plane")
    claim.answers("contact")
    contact, kind = claim.word("contact"), claim.kind()
    kinds = {"disjoint": ("lowest_point",), "touching": ("lowest_point", "flat_axis"),
             "overlapping": ("common_interior_point",)}
    expect(contact in kinds, "truth: contact is wrong")
    expect(kind in kinds[contact], WRONG_KIND)
    flat = kind == "flat_axis"
    claim.facts(*(("point", "axis") if flat else ("point",)))
    x = triple(claim, "point")
    height = dot(normal, x) + offset
    expect(box_holds(low, high, x), "certificate: the point is not in the box")
    if contact == "overlapping":
        inside = all(least < y < greatest for least, y, greatest in zip(low, x, high))
        expect(inside, "certificate: the point is not inside the box")
        expect(height < 0, "certificate: the point is not behind the plane")
    elif flat:
        expect(height <= 0, "certificate: the point is in front of the plane")
        axis = claim.single("axis")
        expect(axis in range(3) and low[int(axis)] == high[int(axis)], "certificate: the box is not flat on the axis")
    else:
        expect(is_lowest(low, high, normal, x), "certificate: a point of the box is lower")
        held = height > 0 if contact == "disjoint" else height == 0
        expect(held, "certificate: the height of the point proves another truth")
