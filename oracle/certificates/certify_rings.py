# SPDX-License-Identifier: Apache-2.0
"""Shared parts of the checks of polygons, as in check_rings.cpp."""

from certify_lines import cross, dot, minus
from certify_reading import Refusal, expect


def edge(ring, i):
    return ring[i], ring[(i + 1) % len(ring)]


def side(line, p):
    value = cross(minus(line[1], line[0]), minus(p, line[0]))
    return (value > 0) - (value < 0)


def beside(a, b):
    return side(a, b[0]) * side(a, b[1]) > 0


def beyond(a, b):
    return any(max(a[0][k], a[1][k]) < min(b[0][k], b[1][k]) for k in (0, 1))


def meet(a, b):
    return not (beside(a, b) or beside(b, a) or beyond(a, b) or beyond(b, a))


def expect_not_degenerate(ring):
    turns = False
    for i in range(len(ring)):
        e = edge(ring, i)
        expect(e[0] != e[1], "truth: neighbours are one point")
        turns = turns or side(e, edge(ring, (i + 1) % len(ring))[1]) != 0
    expect(turns, "truth: all vertices are on one line")


def turns_back(e, following):
    return side(e, following[1]) == 0 and dot(minus(e[1], e[0]), minus(following[1], following[0])) < 0


def defect(ring):
    """Edges i <= j, the first of all: of length zero, or meeting elsewhere than in a vertex that neighbours share."""
    n, edges = len(ring), [edge(ring, i) for i in range(len(ring))]
    for i, e in enumerate(edges):
        if e[0] == e[1]:
            return i, i
    for i, e in enumerate(edges):
        for j in range(i + 1, n):
            if j == i + 1:
                meeting = turns_back(e, edges[j])
            elif i == 0 and j == n - 1:
                meeting = turns_back(edges[j], e)
            else:
                meeting = meet(e, edges[j])
            if meeting:
                return i, j
    return None


def expect_no_edge_of_length_zero(ring, what):
    for i in range(len(ring)):
        a, b = edge(ring, i)
        expect(a != b, f"{what}[{i}]: different from vertex {(i + 1) % len(ring)}: drop one of the two")


def expect_simple(ring, what):
    expect_no_edge_of_length_zero(ring, what)
    found = defect(ring)
    if found is not None:
        raise Refusal(f"{what}[{found[0]}]: simple: its edge must not meet edge {found[1]}")


def vertex(index, ring):
    expect(index.denominator == 1 and 0 <= index < len(ring), "certificate: not an index")
    return int(index)
