# SPDX-License-Identifier: Apache-2.0
"""What the checks of polygons share, as in check_rings.cpp."""

from certify_lines import cross, dot, minus
from certify_reading import expect


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


def expect_simple(ring):
    expect_not_degenerate(ring)
    n = len(ring)
    for i in range(n):
        e, following = edge(ring, i), edge(ring, (i + 1) % n)
        onward = side(e, following[1]) != 0 or dot(minus(e[1], e[0]), minus(following[1], following[0])) > 0
        expect(onward, "truth: the polygon turns back on itself")
        for j in range(i + 2, n - 1 if i == 0 else n):
            expect(not meet(e, edge(ring, j)), "truth: two edges meet")


def vertex(index, ring):
    expect(index.denominator == 1 and 0 <= index < len(ring), "certificate: not an index")
    return int(index)
