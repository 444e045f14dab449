# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of the convexity of polygons, as in check_convexity.cpp."""

from certify_lines import along, cross, dot, minus
from certify_reading import WRONG_KIND, expect, polygon
from certify_rings import edge, expect_not_degenerate, expect_simple, side, vertex


def expect_truth(claim, name, strict, orientation):
    expect(claim.word("class") == name, WRONG_KIND)
    expect(isinstance(claim.truth["strict"], bool), "truth: field strict is missing")
    expect(claim.truth["strict"] == strict, "truth: strict is wrong")
    expect(claim.word("orientation") == orientation, "truth: orientation is wrong")


def winding(ring):
    edges = [edge(ring, i) for i in range(len(ring))]
    return "ccw" if sum((a[0] - b[0]) * (a[1] + b[1]) for a, b in edges) > 0 else "cw"


def degenerate(claim, ring):
    expect_truth(claim, "degenerate", False, "none")
    if claim.kind() == "repeated_neighbour":
        claim.facts("vertex")
        e = edge(ring, vertex(claim.single("vertex"), ring))
        expect(e[0] == e[1], "certificate: these neighbours differ")
        return
    claim.facts("normal", "offset")
    normal, offset = claim.pair("normal"), claim.single("offset")
    expect(normal != (0, 0), "certificate: normal is zero")
    expect(all(dot(normal, p) == offset for p in ring), "certificate: a vertex is not on the line")


def not_simple(claim, ring):
    expect_truth(claim, "not_simple", False, "none"), claim.facts("edges", "parameters")
    expect_not_degenerate(ring)
    edges, at = claim.pair("edges"), claim.pair("parameters")
    i, j = vertex(edges[0], ring), vertex(edges[1], ring)
    a, b = edge(ring, i), edge(ring, j)
    expect(i < j and 0 <= at[0] <= 1 and 0 <= at[1] <= 1, "certificate: not two edges and a point of each")
    p = along(a[0], at[0], minus(a[1], a[0]))
    expect(p == along(b[0], at[1], minus(b[1], b[0])), "certificate: the points differ")
    shared = (j == i + 1 and p == b[0]) or (i == 0 and j == len(ring) - 1 and p == a[0])
    expect(not shared, "certificate: neighbours share this vertex")


def concave(claim, ring):
    expect_simple(ring)
    expect_truth(claim, "concave", False, winding(ring)), claim.facts("edge", "vertices")
    e, vertices = edge(ring, vertex(claim.single("edge"), ring)), claim.pair("vertices")
    left, right = (side(e, ring[vertex(index, ring)]) for index in vertices)
    expect(left > 0 > right, "certificate: the vertices are not on different sides")


def convex(claim, ring):
    expect_simple(ring)
    claim.facts("doubled_area")
    area, n = claim.single("doubled_area"), len(ring)
    sign = (area > 0) - (area < 0)
    for i in range(n):
        one_side = all(side(edge(ring, i), p) * sign >= 0 for p in ring)
        expect(one_side, "truth: a vertex is on the wrong side of an edge")
    expect(area == sum(cross(*edge(ring, i)) for i in range(n)), "certificate: the doubled area is wrong")
    strict = all(side(edge(ring, i), ring[(i + 2) % n]) != 0 for i in range(n))
    expect_truth(claim, "convex", strict, winding(ring))


CONVEXITY = {
    "repeated_neighbour": degenerate,
    "common_line": degenerate,
    "common_point": not_simple,
    "both_sides": concave,
    "one_side": convex,
}


def check_polygon_convexity(claim):
    claim.inputs("polygon"), claim.answers("class", "strict", "orientation")
    ring = polygon(claim.input["polygon"], "polygon")
    kind = claim.kind()
    expect(kind in CONVEXITY, WRONG_KIND)
    CONVEXITY[kind](claim, ring)


check_polygon_convexity_interior_angles = check_polygon_convexity
