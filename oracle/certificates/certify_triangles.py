# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for segments, capsules and triangles of space, as in check_triangles.cpp."""

from certify_reading import expect, list_of_two, number, only
from certify_space import cross, dot, exact_triple, point_in_space, triple


def points(value, what, count, in_words):
    """Two points are the ends of a segment, three the corners of a triangle: all that is between them."""
    expect(isinstance(value, list) and len(value) == count, f"{what}: a list of {in_words}")
    return [point_in_space(point, f"{what}[{i}]") for i, point in enumerate(value)]


def capsule_in_space(value, what):
    """Its segment and its radius."""
    only(value, what, ["segment", "radius"])
    ends, radius = points(value["segment"], what + ".segment", 2, "two"), number(value["radius"], what + ".radius")
    expect(radius >= 0, what + ".radius: radius >= 0")
    return ends, radius


def weighted(corners, weights):
    """The point with these weights."""
    point = (0, 0, 0)
    for weight, corner in zip(weights, corners):
        expect(weight >= 0, "certificate: a weight is negative")
        point = tuple(x + weight * c for x, c in zip(point, corner))
    expect(sum(weights) == 1, "certificate: the weights do not add up to 1")
    return point


def expect_nothing_before(plane, corners, end, x):
    """A plane with none of the triangle in front of it, `end` in front and x not behind: so is all from the end to x,
    but x itself."""
    reason = "certificate: the plane does not keep the triangle apart"
    expect(len(plane) == 4, reason)
    normal, offset = plane[:3], plane[3]
    expect(all(dot(normal, corner) <= offset for corner in corners), reason)
    expect(dot(normal, end) > offset and dot(normal, x) >= offset, reason)


def at(s, t):
    return tuple(a + t * (b - a) for a, b in zip(*s))


def check_segment_triangle(claim):
    claim.inputs("segment", "triangle")
    s = points(claim.input["segment"], "segment", 2, "two")
    corners = points(claim.input["triangle"], "triangle", 3, "three")
    relation = claim.word("relation")
    if relation == "none":
        claim.answers("relation"), claim.expect_kind("separating_plane"), claim.facts("normal", "offset")
        normal, offset = triple(claim, "normal"), claim.single("offset")
        separates = all(dot(normal, p) > offset for p in s) and all(dot(normal, p) < offset for p in corners)
        expect(separates, "certificate: the plane does not separate")
        return
    expect(relation in ("point", "segment"), "truth: relation is wrong")
    claim.answers("relation", *(["t", "point"] if relation == "point" else ["overlap"]))
    claim.expect_kind("common_part"), claim.facts("on_segment", "weights", "before", "after")
    t, weights, before, after = map(claim.list, ("on_segment", "weights", "before", "after"))
    expect(len(t) in (1, 2) and len(weights) == 3 * len(t), "certificate: one or two common points")
    rising = 0 <= t[0] and t[-1] <= 1 and (len(t) == 1 or t[0] < t[1])
    expect(rising, "certificate: the parameters do not rise from 0 to 1")
    one_point = s[0] == s[1]
    common = [at(s, parameter) for parameter in t]
    for i, point in enumerate(common):
        expect(weighted(corners, weights[3 * i:3 * i + 3]) == point, "certificate: the weights give another point")
    if t[0] > 0 or before:
        expect_nothing_before(before, corners, s[0], common[0])
    if (t[-1] < 1 and not one_point) or after:
        expect_nothing_before(after, corners, s[1], common[-1])
    expect((len(t) == 1) == (relation == "point"), "truth: relation is wrong")
    if relation == "point":
        expect(claim.exact("t") == t[0], "truth: t is wrong")
        expect(exact_triple(claim.truth["point"], "truth.point") == common[0], "truth: point is not at t")
        return
    overlap = list_of_two(claim.truth["overlap"], "truth.overlap")
    ends = [exact_triple(end, f"truth.overlap[{i}]") for i, end in enumerate(overlap)]
    expect(ends == common, "truth: overlap is wrong")
    expect(not one_point, "certificate: a segment of length zero is one point")


def rank(displacements):
    """Returns the number of independent displacements."""
    independent = []
    for v in displacements:
        if not independent:
            adds = any(v)
        elif len(independent) == 1:
            adds = any(cross(independent[0], v))
        else:
            adds = len(independent) == 2 and dot(cross(*independent), v) != 0
        if adds:
            independent.append(v)
    return len(independent)


def ways(corners):
    return [tuple(x - y for x, y in zip(p, corners[0])) for p in corners]


def in_plane(plane, side, corners):
    """Returns the corners that are in the plane; `side` times the heights of the others is positive."""
    heights = [side * (dot(plane, corner) - plane[3]) for corner in corners]
    expect(all(height >= 0 for height in heights), "certificate: the plane does not separate")
    return [corner for corner, height in zip(corners, heights) if height == 0]


def most_dimensions(a, b):
    """The common part lies in each of the planes, so what is left of both holds it, and with it the planes, lines or
    points that they span."""
    return rank(ways(a)) + rank(ways(b)) - rank(ways(a) + ways(b))


def check_triangle_triangle(claim):
    claim.inputs("a", "b")
    a, b = (points(claim.input[name], name, 3, "three") for name in "ab")
    claim.answers("relation"), claim.expect_kind("dimension"), claim.facts("planes", "on_a", "on_b")
    planes, on_a, on_b = map(claim.list, ("planes", "on_a", "on_b"))
    expect(len(planes) % 4 == 0, "certificate: four numbers a plane")
    of_a, of_b = a, b
    for i in range(0, len(planes), 4):
        of_a, of_b = in_plane(planes[i:i + 4], -1, of_a), in_plane(planes[i:i + 4], 1, of_b)
    expect(len(on_a) % 3 == 0 and len(on_a) == len(on_b), "certificate: three weights a point")
    common = []
    for i in range(0, len(on_a), 3):
        common.append(weighted(a, on_a[i:i + 3]))
        expect(weighted(b, on_b[i:i + 3]) == common[-1], "certificate: the weights give another point")
    relation = claim.word("relation")
    if not common:
        expect(not of_a or not of_b, "certificate: corners are left of both")
        expect(relation == "none", "truth: relation is wrong")
        return
    dimension = rank(ways(common))
    expect(dimension >= most_dimensions(of_a, of_b), "certificate: the planes leave more than the points show")
    expect(relation == ("point", "segment", "area")[dimension], "truth: relation is wrong")
