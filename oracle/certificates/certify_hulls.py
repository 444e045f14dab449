# SPDX-License-Identifier: Apache-2.0
"""Convex hulls, as in check_hulls.cpp, where it is said why that proves them."""

from math import lcm

from certify_lines import cross, dot, minus
from certify_reading import WRONG_KIND, expect, point
from certify_rings import side
from certify_space import cross as cross_in_space
from certify_space import dot as dot_in_space
from certify_space import point_in_space


def place(value, what, count):
    expect(type(value) is int and 0 <= value < count, what + ": not an index")
    return value


def places(values, what, fewest, count):
    expect(isinstance(values, list) and len(values) >= fewest, f"{what}: a list of at least {fewest}")
    return [place(value, what, count) for value in values]


def dimension(claim):
    there = isinstance(claim.truth, dict) and type(claim.truth.get("dimension")) is int
    expect(there and claim.truth["dimension"] >= 0, "truth: field dimension is missing")
    return claim.truth["dimension"]


def corners(claim, count):
    """The corners that the truth names where it is no solid."""
    if dimension(claim) == 0:
        claim.answers("dimension", "point")
        return [place(claim.truth["point"], "truth.point", count)]
    if dimension(claim) == 1:
        claim.answers("dimension", "segment")
        ends = places(claim.truth["segment"], "truth.segment", 2, count)
        expect(len(ends) == 2, "truth.segment: a list of two")
        return ends
    expect(dimension(claim) == 2, "truth: dimension is wrong")
    claim.answers("dimension", "polygon")
    return places(claim.truth["polygon"], "truth.polygon", 3, count)


def expect_extreme(claim, used):
    expect(sorted(claim.list("extreme")) == sorted(used), "certificate: extreme are other points than in the truth")


def expect_kind(claim, kind):
    claim.expect_kind(kind)
    claim.facts("extreme")


def between(a, p, b):
    if len(a) == 2:
        return cross(minus(b, a), minus(p, a)) == 0 and dot(minus(p, a), minus(p, b)) <= 0
    from_a, from_b = minus_in_space(p, a), minus_in_space(p, b)
    return cross_in_space(minus_in_space(b, a), from_a) == (0, 0, 0) and dot_in_space(from_a, from_b) <= 0


def minus_in_space(p, q):
    return p[0] - q[0], p[1] - q[1], p[2] - q[2]


def expect_polygon(points, ring):
    tips = [points[i] for i in ring]
    for i, tip in enumerate(tips):
        edge = tip, tips[(i + 1) % len(tips)]
        expect(side(edge, tips[(i + 2) % len(tips)]) > 0, "truth: no turn to the left at a corner")
        for p in points:
            expect(side(edge, p) >= 0, "truth: a point is outside")
        expect(tip not in tips[:i], "truth: a corner twice")


def listed_points(claim, read):
    claim.inputs("points")
    values = claim.input["points"]
    expect(isinstance(values, list), "points: a list")
    expect(len(values) > 0, "points: at least 1 point")
    return [read(value, f"points[{i}]") for i, value in enumerate(values)]


def check_flat(claim, points):
    ring = corners(claim, len(points))
    expect_kind(claim, ("one_point", "segment", "polygon")[min(len(ring), 3) - 1])
    if len(ring) == 1:
        expect(all(p == points[0] for p in points), "truth: the points are not all equal")
    elif len(ring) == 2:
        a, b = (points[i] for i in ring)
        expect(a != b, "truth: the ends are one point")
        expect(all(between(a, p, b) for p in points), "truth: a point is outside")
    elif len(points[0]) == 2:
        expect_polygon(points, ring)
    else:
        expect_polygon_in_space(points, ring)
    expect_extreme(claim, ring)


def check_convex_hull_2d(claim):
    check_flat(claim, listed_points(claim, point))


def whole(points):
    """In integers times one unit, which is faster: sides stay."""
    unit = lcm(*(number.denominator for p in points for number in p))
    return [tuple(int(number * unit) for number in p) for p in points]


def expect_polygon_in_space(points, ring):
    tips = [points[i] for i in ring]
    normal = cross_in_space(minus_in_space(tips[1], tips[0]), minus_in_space(tips[2], tips[0]))
    for i, tip in enumerate(tips):
        edge = minus_in_space(tips[(i + 1) % len(tips)], tip)
        turn = dot_in_space(normal, cross_in_space(edge, minus_in_space(tips[(i + 2) % len(tips)], tip)))
        expect(turn > 0, "truth: no turn to the left at a corner")
        for p in points:
            way = minus_in_space(p, tip)
            expect(dot_in_space(normal, way) == 0, "truth: a point is off the plane")
            expect(dot_in_space(normal, cross_in_space(edge, way)) >= 0, "truth: a point is outside")
        expect(tip not in tips[:i], "truth: a corner twice")


def faces(values, count):
    expect(isinstance(values, list) and len(values) >= 4, "truth.faces: a list of at least 4")
    found = []
    for value in values:
        found.append(places(value, "truth.faces", 3, count))
        expect(len(found[-1]) == 3, "truth.faces: three places each")
    return found


def span_space(normals):
    line = (0, 0, 0)
    for n in normals:
        if dot_in_space(line, n) != 0:
            return True
        if line == (0, 0, 0):
            line = cross_in_space(normals[0], n)
    return False


def expect_faces(points, triangles):
    edges, normals = set(), {}
    for t in triangles:
        a, b, c = (points[i] for i in t)
        normal = cross_in_space(minus_in_space(b, a), minus_in_space(c, a))
        expect(normal != (0, 0, 0), "truth: a face has no area")
        for edge in zip(t, t[1:] + t[:1]):
            expect(edge not in edges, "truth: an edge twice in one direction")
            edges.add(edge)
            normals.setdefault(edge[0], []).append(normal)
        level = dot_in_space(normal, a)
        heights = [dot_in_space(normal, p) for p in points]
        expect(max(heights) <= level, "truth: a point is outside")
        expect(min(heights) < level, "truth: all points are in one plane")
    for i, k in edges:
        expect((k, i) in edges, "truth: an edge in one direction only")
    seen = set()
    for corner in sorted(normals):
        expect(span_space(normals[corner]), "truth: a corner is not extreme")
        expect(points[corner] not in seen, "truth: a corner twice")
        seen.add(points[corner])
    return list(normals)


def check_convex_hull(claim):
    points = whole(listed_points(claim, point_in_space))
    if dimension(claim) == 3:
        claim.answers("dimension", "faces")
        triangles = faces(claim.truth["faces"], len(points))
        expect_kind(claim, "faces")
        expect_extreme(claim, expect_faces(points, triangles))
    else:
        check_flat(claim, points)
