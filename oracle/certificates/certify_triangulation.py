# SPDX-License-Identifier: Apache-2.0
"""Polygons cut into convex pieces, as in check_triangulation.cpp, where the proof is written down."""

from certify_lines import cross, minus
from certify_reading import WRONG_KIND, expect, polygon
from certify_rings import edge, expect_simple, side


def pieces(claim, name, ring):
    claim.answers(name)
    what = "truth." + name
    listed = claim.truth[name]
    expect(isinstance(listed, list), what + ": a list")
    for piece in listed:
        expect(isinstance(piece, list) and len(piece) >= 3, what + ": a list of at least three in each place")
        for index in piece:
            expect(type(index) is int and 0 <= index < len(ring), what + ": not an index")
        expect(len(set(piece)) == len(piece), "truth: a vertex twice in a piece")
    return listed


def edges_of(piece):
    return list(zip(piece, piece[1:] + piece[:1]))


def expect_convex(ring, piece):
    for i, k in edges_of(piece):
        sides = [side((ring[i], ring[k]), ring[p]) for p in piece]
        expect(min(sides) >= 0, "truth: a piece is not convex and counter-clockwise")
        expect(max(sides) > 0, "truth: a piece has no area")


def doubled_area(ring, piece):
    start = ring[piece[0]]
    return sum(cross(minus(ring[i], start), minus(ring[k], start)) for i, k in zip(piece[1:], piece[2:]))


def expect_matched(found, around):
    edges = set()
    for piece in found:
        for edge in edges_of(piece):
            expect(edge not in edges, "truth: two pieces on the same side of an edge")
            edges.add(edge)
    for edge in edges_of(around):
        expect(edge in edges, "truth: an edge of the polygon is in no piece")
        edges.remove(edge)
    for i, k in edges:
        expect((k, i) in edges, "truth: a piece on one side of an edge only")


def proved(claim, name, ring):
    expect_simple(ring, "polygon")
    found = pieces(claim, name, ring)
    expect(claim.kind() == "pieces", WRONG_KIND)
    claim.facts("doubled_area")
    for piece in found:
        expect_convex(ring, piece)
    around = list(range(len(ring)))
    whole = doubled_area(ring, around)
    if whole < 0:
        around.reverse()
        whole = -whole
    expect_matched(found, around)
    total = sum(doubled_area(ring, piece) for piece in found)
    expect(claim.single("doubled_area") == whole == total, "certificate: the doubled area is wrong")
    return found


def check_triangulate_polygon(claim):
    claim.inputs("polygon")
    ring = polygon(claim.input["polygon"], "polygon")
    for piece in proved(claim, "triangles", ring):
        expect(len(piece) == 3, "truth: not a triangle")


def check_convex_partition(claim):
    claim.inputs("polygon")
    ring = polygon(claim.input["polygon"], "polygon")
    found = proved(claim, "pieces", ring)
    turns = [side(edge(ring, i), ring[(i + 2) % len(ring)]) for i in range(len(ring))]
    direction = 1 if doubled_area(ring, list(range(len(ring)))) > 0 else -1
    reflex = sum(turn * direction < 0 for turn in turns)
    expect(len(found) <= 2 * reflex + 1, "truth: more pieces than four times the least number")
