# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for two polygons, as in check_overlap.cpp."""

from certify_reading import WRONG_KIND, expect, polygon
from certify_rings import edges_of, expect_simple, meet, region


def height(e, x):
    (ax, ay), (bx, by) = e
    return ay + (x - ax) / (bx - ax) * (by - ay)


def spanning(edges, left, right):
    return [e for e in edges if min(e[0][0], e[1][0]) <= left and max(e[0][0], e[1][0]) >= right]


def expect_inside(edges, p):
    above = 0
    for e in edges:
        expect(e[0][0] != p[0], "certificate: a vertex is straight above or below the point")
        if (e[0][0] < p[0]) == (e[1][0] < p[0]):
            continue
        y = height(e, p[0])
        expect(y != p[1], "certificate: the point is on a boundary")
        above += y > p[1]
    expect(above % 2 == 1, "certificate: the point is not inside")


def expect_apart_in_slab(a, b, left, right):
    of_a, of_b = spanning(a, left, right), spanning(b, left, right)
    for e in of_a:
        for f in of_b:
            before, after = height(e, left) - height(f, left), height(e, right) - height(f, right)
            expect(min(before, after) >= 0 or max(before, after) <= 0, "certificate: edges cross inside a slab")
    middle = (left + right) / 2
    low_a, low_b = (sorted(height(e, middle) for e in edges) for edges in (of_a, of_b))
    for i in range(0, len(low_a) - 1, 2):
        for j in range(0, len(low_b) - 1, 2):
            apart = low_a[i + 1] <= low_b[j] or low_b[j + 1] <= low_a[i]
            expect(apart, "truth: the polygons overlap in a slab")


def expect_no_overlap(a, b, cuts):
    for p, _ in a + b:
        expect(p[0] in cuts, "certificate: no cut at a vertex")
    for left, right in zip(cuts, cuts[1:]):
        expect(left < right, "certificate: the cuts do not ascend")
        expect_apart_in_slab(a, b, left, right)


def expect_contact(claim, a, b):
    """a, b: all edges of either."""
    claim.answers("contact")
    contact = claim.word("contact")
    if contact == "overlapping":
        expect(claim.kind() == "common_interior_point", WRONG_KIND)
        claim.facts("point")
        p = claim.pair("point")
        expect_inside(a, p), expect_inside(b, p)
        return
    expect(contact in ("touching", "disjoint"), "truth: contact is wrong")
    expect(claim.kind() == "slabs", WRONG_KIND)
    claim.facts("cuts", "point") if contact == "touching" else claim.facts("cuts")
    expect_no_overlap(a, b, claim.list("cuts"))
    if contact == "touching":
        p = claim.pair("point")
        on_both = all(any(meet(e, (p, p)) for e in edges) for edges in (a, b))
        expect(on_both, "certificate: the point is not on both boundaries")
        return
    for e in a:
        for f in b:
            expect(not meet(e, f), "truth: the boundaries meet")


def check_polygon_polygon(claim):
    claim.inputs("a", "b")
    a = polygon(claim.input["a"], "a")
    expect_simple(a, "a")
    b = polygon(claim.input["b"], "b")
    expect_simple(b, "b")
    expect_contact(claim, edges_of(a), edges_of(b))


def check_region_region(claim):
    claim.inputs("a", "b")
    a, b = region(claim.input["a"], "a"), region(claim.input["b"], "b")
    expect_contact(claim, edges_of(*a), edges_of(*b))
