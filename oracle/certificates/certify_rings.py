# SPDX-License-Identifier: Apache-2.0
"""Shared parts of the checks of polygons, as in check_rings.cpp."""

from fractions import Fraction

from certify_lines import along, cross, dot, minus
from certify_reading import Refusal, expect, only, polygon


def edge(ring, i):
    return ring[i], ring[(i + 1) % len(ring)]


def edges_of(*rings):
    """All edges, of several rings one after the other."""
    return [edge(ring, i) for ring in rings for i in range(len(ring))]


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


def cross_or_coincide(a, b):
    """Edges of two rings that cross, or have a piece in common."""
    for e in edges_of(a):
        for f in edges_of(b):
            at_ends = side(e, f[0]), side(e, f[1])
            if at_ends[0] * at_ends[1] < 0 and side(f, e[0]) * side(f, e[1]) < 0:
                return True
            v = minus(e[1], e[0])
            s, t = sorted(dot(minus(p, e[0]), v) for p in f)
            if at_ends == (0, 0) and max(0, s) < min(dot(v, v), t):
                return True
    return False


def inside(ring, p):
    """By the edges above p, which is on none."""
    return sum((e[0][0] < p[0]) != (e[1][0] < p[0]) and (side(e, p) > 0) == (e[0][0] > e[1][0])
               for e in edges_of(ring)) % 2 == 1


def middles(ring, other):
    """One for every piece of a ring between vertices of the other."""
    for e in edges_of(ring):
        v = minus(e[1], e[0])
        places = [dot(minus(p, e[0]), v) / dot(v, v) for p in other if side(e, p) == 0]
        cuts = sorted({0, 1, *(t for t in places if 0 < t < 1)})
        yield from (along(e[0], (s + t) / Fraction(2), v) for s, t in zip(cuts, cuts[1:]))


def region(value, what):
    """A region's rings, the outer one first, which have to fit together; check_rings.h says how that is proved."""
    only(value, what, ["outer", "holes"])
    expect(isinstance(value["holes"], list), what + ".holes: a list of rings")
    names = [what + ".outer"] + [f"{what}.holes[{i}]" for i in range(len(value["holes"]))]
    rings = [polygon(ring, name) for ring, name in zip([value["outer"], *value["holes"]], names)]
    for ring, name in zip(rings, names):
        expect_simple(ring, name)
    for i in range(1, len(rings)):
        outside = cross_or_coincide(rings[i], rings[0]) or not all(inside(rings[0], p) for p in middles(rings[i], rings[0]))
        expect(not outside, names[i] + ": inside the outer ring, which it may touch in single points only")
        for j in range(1, i):
            meet_inside = any(inside(rings[k], p) for k, m in ((i, j), (j, i)) for p in middles(rings[m], rings[k]))
            expect(not cross_or_coincide(rings[i], rings[j]) and not meet_inside,
                   f"{names[i]}: outside hole {j - 1}, which it may touch in single points only")
    return rings
