# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for the convexity of polygons, as in check_convexity.cpp."""

from fractions import Fraction
from math import floor

from certify_circle import cosine_and_sine, all_bits
from certify_lines import along, cross, dot, minus
from certify_reading import WRONG_KIND, exact_value, expect, polygon
from certify_rings import defect, edge, expect_not_degenerate, expect_simple, side, vertex
from certify_rounding import expect_rounds_alike


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


def expect_simple_as_claimed(ring):
    expect_not_degenerate(ring)
    expect(defect(ring) is None, "truth: two edges meet")


def concave(claim, ring):
    expect_simple_as_claimed(ring)
    expect_truth(claim, "concave", False, winding(ring)), claim.facts("edge", "vertices")
    e, vertices = edge(ring, vertex(claim.single("edge"), ring)), claim.pair("vertices")
    left, right = (side(e, ring[vertex(index, ring)]) for index in vertices)
    expect(left > 0 > right, "certificate: the vertices are not on different sides")


def convex(claim, ring):
    expect_simple_as_claimed(ring)
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
    claim.inputs("polygon")
    ring = polygon(claim.input["polygon"], "polygon")
    claim.answers("class", "strict", "orientation")
    kind = claim.kind()
    expect(kind in CONVEXITY, WRONG_KIND)
    CONVEXITY[kind](claim, ring)


check_polygon_convexity_interior_angles = check_polygon_convexity


def turn_from(u, vector, bits):
    cosine, sine = cosine_and_sine(u, floor(u * 7 / 11 + Fraction(1, 2)), bits)
    x, y = vector
    low = y * cosine[y < 0] - x * sine[x >= 0]
    high = y * cosine[y >= 0] - x * sine[x < 0]
    return 1 if low > 0 else -1 if high < 0 else 0


def expect_angle(vector, low, high, bits):
    reason = "certificate: an angle is not between low and high"
    expect(0 < low < high and high - low < 1, reason)
    expect(low > 3 and high < 7 if vector[1] < 0 else high < 4, reason)
    expect(turn_from(low, vector, bits) > 0 > turn_from(high, vector, bits), reason)


def check_interior_angles(claim):
    claim.inputs("polygon")
    ring = polygon(claim.input["polygon"], "polygon")
    expect_simple(ring, "polygon")
    claim.answers("angles")
    claim.expect_kind("enclosure"), claim.facts("low", "high", "bits")
    low, high = claim.list("low"), claim.list("high")
    angles, n = claim.truth["angles"], len(ring)
    expect(isinstance(angles, list) and len(angles) == n, "truth.angles: one for each vertex")
    expect(len(low) == n and len(high) == n, "certificate: low and high for each vertex")
    bits = all_bits(claim.single("bits"))
    sign = 1 if winding(ring) == "ccw" else -1
    for i, p in enumerate(ring):
        following, previous = minus(ring[(i + 1) % n], p), minus(ring[i - 1], p)
        expect_angle((dot(following, previous), sign * cross(following, previous)), low[i], high[i], bits)
        angle = exact_value(angles[i], f"truth.angles[{i}]")
        expect(low[i] < angle < high[i], "truth: an angle is not between low and high")
        expect_rounds_alike("angles", angle, low[i], high[i])
