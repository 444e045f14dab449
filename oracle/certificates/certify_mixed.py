# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for shapes of two chapters, one function for each operation, as in check_mixed.cpp."""

from certify_reading import WRONG_KIND, expect
from certify_space import box_holds, box_in_space, dot, triple
from certify_triangles import points, weighted

def expect_between(claim, corners, box, disjoint):
    """Checks the plane; check_mixed.cpp says what it has to keep apart."""
    normal, offset = triple(claim, "normal"), claim.single("offset")
    expect(normal != (0, 0, 0), "certificate: the normal is zero")
    lowest = tuple(least if slope > 0 else greatest for slope, least, greatest in zip(normal, *box))
    heights = [dot(normal, corner) - offset for corner in corners] + [offset - dot(normal, lowest)]
    kept = all(height < 0 if disjoint else height <= 0 for height in heights)
    expect(kept, "certificate: the plane does not separate")


TRIANGLE_AABB = {
    "disjoint": {"separating_plane": ("normal", "offset")},
    "touching": {"supporting_plane": ("normal", "offset", "weights"), "flat_axis": ("weights", "axis")},
    "overlapping": {"common_interior_point": ("weights",)},
}


def check_triangle_aabb(claim):
    claim.inputs("triangle", "aabb")
    corners, box = points(claim.input["triangle"], "triangle", 3, "three"), box_in_space(claim.input["aabb"], "aabb")
    claim.answers("contact")
    contact, kind = claim.word("contact"), claim.kind()
    expect(contact in TRIANGLE_AABB, "truth: contact is wrong")
    expect(kind in TRIANGLE_AABB[contact], WRONG_KIND)
    claim.facts(*TRIANGLE_AABB[contact][kind])
    if contact == "disjoint":
        expect_between(claim, corners, box, True)
        return
    weights = claim.list("weights")
    expect(len(weights) == 3, "certificate: as many weights as points")
    x = weighted(corners, weights)
    expect(box_holds(*box, x), "certificate: the point is not in the box")
    if contact == "overlapping":
        inside = all(least < y < greatest for least, y, greatest in zip(box[0], x, box[1]))
        expect(inside, "certificate: the point is not inside the box")
    elif kind == "flat_axis":
        axis = claim.single("axis")
        flat = axis in range(3) and box[0][int(axis)] == box[1][int(axis)]
        expect(flat, "certificate: the box is not flat on the axis")
    else:
        expect_between(claim, corners, box, False)
