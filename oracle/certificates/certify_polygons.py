# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for polygons, one function for each operation, as in check_polygons.cpp."""

from certify_lines import along, cross, minus, within
from certify_reading import expect, point, polygon
from certify_rings import edge, edges_of, expect_no_edge_of_length_zero, expect_simple, region, side, vertex
from certify_sums import direction


def expect_crossings(claim, edges_around, p):
    claim.facts("direction", "edges", "t")
    step, edges, parameters = claim.pair("direction"), claim.list("edges"), claim.list("t")
    expect(len(edges) == len(parameters), "certificate: a parameter for each edge")
    ray, around = direction(step), [(minus(a, p), minus(b, p)) for a, b in edges_around]
    expect(all(cross(ray, a) != 0 for a, _ in around), "certificate: the direction does not miss every vertex")
    listed = set()
    for index, t in zip(edges, parameters):
        i = vertex(index, edges_around)
        expect(i not in listed, "certificate: an edge is listed twice")
        listed.add(i)
        on_line = side(edges_around[i], along(p, t, step)) == 0
        expect(t > 0 and on_line, "certificate: a parameter is wrong")
    for i, (a, b) in enumerate(around):
        start, end = cross(ray, a) > 0, cross(ray, b) > 0
        expect(start == end or cross(a, b) != 0, "certificate: the point is on an edge")
        crossed = start != end and (cross(a, b) > 0) == end
        expect(crossed == (i in listed), "certificate: not the edges that the ray crosses")
    expect(claim.word("location") == ("inside" if len(listed) % 2 else "outside"), "truth: location is wrong")


def expect_location(claim, edges, p):
    """The location of a point among the edges of closed rings, by parity."""
    claim.answers("location")
    if claim.kind() == "crossings":
        expect_crossings(claim, edges, p)
        return
    claim.expect_kind("on_edge"), claim.facts("edge", "t")
    a, b = edges[vertex(claim.single("edge"), edges)]
    t = claim.single("t")
    expect(within(t) and p == along(a, t, minus(b, a)), "certificate: the point is not there on the edge")
    expect(claim.word("location") == "boundary", "truth: location is wrong")


def check_point_in_polygon(claim):
    claim.inputs("polygon", "point")
    ring = polygon(claim.input["polygon"], "polygon")
    expect_location(claim, edges_of(ring), point(claim.input["point"], "point"))


def check_point_in_region(claim):
    claim.inputs("region", "point")
    rings = region(claim.input["region"], "region")
    expect_location(claim, edges_of(*rings), point(claim.input["point"], "point"))


def expect_convex(ring, what):
    expect_no_edge_of_length_zero(ring, what)
    n, total = len(ring), sum((p[0] - q[0]) * (p[1] + q[1]) for p, q in zip(ring, ring[1:] + ring[:1]))
    turns = [side(edge(ring, (i + n - 1) % n), ring[(i + 1) % n]) for i in range(n)]
    expect(any(turns), what + ": convex: vertices on one line have no inside")
    expect_simple(ring, what)
    for i, turn in enumerate(turns):
        expect(turn * total >= 0, f"{what}[{i}]: convex: the ring must not turn against its direction")


def check_point_in_convex_polygon(claim):
    claim.inputs("polygon", "point")
    ring, p = polygon(claim.input["polygon"], "polygon"), point(claim.input["point"], "point")
    expect_convex(ring, "polygon")
    claim.answers("location")
    if claim.kind() == "separating_edge":
        claim.facts("edge")
        e = edge(ring, vertex(claim.single("edge"), ring))
        beyond = side(e, p) != 0 and all(side(e, v) * side(e, p) <= 0 for v in ring)
        expect(beyond, "certificate: the edge does not separate")
        expect(claim.word("location") == "outside", "truth: location is wrong")
        return
    claim.expect_kind("barycentric"), claim.facts("corners", "weights")
    corners, weights = claim.list("corners"), claim.list("weights")
    expect(len(corners) == len(weights) == 3, "certificate: three corners and their weights")
    combination = (0, 0)
    for corner, weight in zip(corners, weights):
        expect(weight >= 0, "certificate: a weight is negative")
        combination = along(combination, weight, ring[vertex(corner, ring)])
    expect(sum(weights) == 1 and combination == p, "certificate: the weights give another point")
    on = any(side(edge(ring, i), p) == 0 for i in range(len(ring)))
    expect(claim.word("location") == ("boundary" if on else "inside"), "truth: location is wrong")
