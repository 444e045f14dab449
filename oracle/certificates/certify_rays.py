# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for rays and segments, one function for each operation, as in check_rays.cpp and
check_passages.cpp.

A line is (from, way, ends): the points from + t way with t >= 0, and t <= 1 where it ends."""

from certify_meshes import listed_faces, part_of
from certify_obbs import obb, reach
from certify_reading import WRONG_KIND, Claim, expect, list_of_two, only
from certify_solids import index
from certify_space import ball_or_disc, box, cross, dot, exact_triple, minus, plane, point_in_space, two_or_three
from certify_surd import exact_surd
from certify_triangles import capsule_in_space, expect_nothing_before, points, weighted


def along(start, t, way):
    return tuple(x + t * v for x, v in zip(start, way))


def segment_in_space(value, what):
    a, b = points(value, what, 2, "two")
    return a, tuple(y - x for x, y in zip(a, b)), True


def ray_in_space(value, what):
    only(value, what, ["origin", "direction"])
    origin = point_in_space(value["origin"], what + ".origin")
    way = point_in_space(value["direction"], what + ".direction")
    expect(any(way), what + ".direction: nonzero direction")
    return origin, way, False


def prove_line_plane(claim, line, level):
    """Why each proves it stands in check_rays.cpp."""
    (start, way, ends), (normal, offset) = line, level
    relation = claim.word("relation")
    expect(relation in ("none", "point", "inside"), "truth: relation is wrong")
    claim.answers("relation", *(["t", "point"] if relation == "point" else []))
    claim.expect_kind("heights"), claim.facts("heights")
    first, second = claim.pair("heights")
    heights = tuple(dot(normal, along(start, t, way)) + offset for t in (0, 1))
    expect((first, second) == heights, "certificate: the heights are wrong")
    climb = second - first
    if relation == "inside":
        expect(first == second == 0, "truth: relation is wrong")
    elif relation == "none":
        misses = first * second > 0 if ends else first != 0 and first * climb >= 0
        expect(misses, "truth: relation is wrong")
    else:
        t = claim.exact("t")
        on_line = t >= 0 and (not ends or t <= 1)
        expect(climb != 0 and on_line and first + t * climb == 0, "truth: t is wrong")
        expect(exact_triple(claim.truth["point"], "truth.point") == along(start, t, way), "truth: point is not at t")


def check_segment_plane(claim):
    claim.inputs("segment", "plane")
    line = segment_in_space(claim.input["segment"], "segment")
    prove_line_plane(claim, line, plane(claim.input["plane"], "plane"))


def check_ray_plane(claim):
    claim.inputs("ray", "plane")
    line = ray_in_space(claim.input["ray"], "ray")
    prove_line_plane(claim, line, plane(claim.input["plane"], "plane"))


def expect_apart(level, until, ray, corners):
    """Why it proves it stands in check_rays.cpp."""
    expect(len(level) == 4, "certificate: a plane has four numbers")
    normal, offset = level[:3], level[3]
    start, way, _ = ray
    end = along(start, until, way)
    apart = dot(normal, start) > offset and dot(normal, end) > offset
    expect(apart, "certificate: the plane does not separate")
    for corner in corners:
        expect(dot(normal, corner) < offset, "certificate: the plane does not separate")
        expect(dot(way, minus(end, corner)) > 0, "certificate: a corner is farther ahead")


def proved_first(proof, ray, corners, points):
    """The first common point: its t, itself, whether it is inside."""
    t, weights, before = map(proof.list, ("on_ray", "weights", "before"))
    expect(len(t) == points and len(weights) == 3 * len(t), "certificate: one common point, or two")
    one = points == 1
    expect(t[0] >= 0 and (one or t[0] < t[1]), "certificate: the parameters do not rise from 0")
    start, way, _ = ray
    common = [along(start, parameter, way) for parameter in t]
    for i, point in enumerate(common):
        expect(weighted(corners, weights[3 * i:3 * i + 3]) == point, "certificate: the weights give another point")
    if t[0] > 0 or before:
        expect_nothing_before(before, corners, start, common[0])
    area = any(cross(minus(corners[1], corners[0]), minus(corners[2], corners[0])))
    return t[0], common[0], area and all(weight > 0 for weight in weights[:3])


def expect_first(claim, first):
    expect(claim.exact("t") == first[0], "truth: t is wrong")
    expect(exact_triple(claim.truth["point"], "truth.point") == first[1], "truth: point is not at t")


def check_ray_triangle(claim):
    claim.inputs("ray", "triangle")
    ray = ray_in_space(claim.input["ray"], "ray")
    corners = points(claim.input["triangle"], "triangle", 3, "three")
    relation = claim.word("relation")
    expect(relation in ("none", "point", "segment"), "truth: relation is wrong")
    if relation == "none":
        claim.answers("relation"), claim.expect_kind("separating_plane"), claim.facts("plane", "until")
        expect_apart(claim.list("plane"), claim.single("until"), ray, corners)
        return
    one = relation == "point"
    claim.answers("relation", "t", "point", *(["location"] if one else []))
    claim.expect_kind("common_part"), claim.facts("on_ray", "weights", "before", "after")
    first = proved_first(claim, ray, corners, 1 if one else 2)
    after = claim.list("after")
    if one or after:
        expect_nothing_before(after, corners, along(first[1], 1, ray[1]), first[1])
    expect_first(claim, first)
    if one:
        expect(claim.word("location") == ("inside" if first[2] else "boundary"), "truth: location is wrong")


def check_ray_mesh(claim):
    claim.inputs("ray", "mesh")
    ray = ray_in_space(claim.input["ray"], "ray")
    vertices, faces = listed_faces(claim.input["mesh"], "mesh")
    relation = claim.word("relation")
    expect(relation in ("none", "hit"), "truth: relation is wrong")
    claim.answers("relation", *(["first"] if relation == "hit" else []), "faces_met")
    claim.expect_kind("faces"), claim.facts("until", "missed", "met")
    until, proved, met = claim.single("until"), set(), {}

    def corners_of(value):
        face = index(value, len(faces))
        expect(face not in proved, "certificate: a face is proved twice")
        proved.add(face)
        return [vertices[corner] for corner in faces[face]]

    for proof in claim.proofs("missed"):
        proof.expect_kind("separating_plane"), proof.facts("plane", "faces")
        plane = proof.list("plane")
        for face in proof.list("faces"):
            expect_apart(plane, until, ray, corners_of(face))
    for proof in claim.proofs("met"):
        proof.expect_kind("common_part"), proof.facts("face", "on_ray", "weights", "before")
        first = proved_first(proof, ray, corners_of(proof.single("face")), 1)
        met[first[0], faces.face_of[index(proof.single("face"), len(faces))]] = first
    expect(len(proved) == len(faces), "certificate: a face is left out")
    expect(relation == ("hit" if met else "none"), "truth: relation is wrong")

    def is_count(given, number):
        return type(given) is int and given == number

    expect(is_count(claim.truth["faces_met"], len({face for _, face in met})), "truth: faces_met is wrong")
    if not met:
        return
    hit = Claim({"input": claim.input, "truth": claim.truth["first"], "certificate": claim.certificate})
    hit.answers("t", "point", "face", "part")
    (_, face), first = min(met.items(), key=lambda item: item[0])
    expect_first(hit, first)
    expect(is_count(hit.truth["face"], face), "truth: face is wrong")
    expect(hit.word("part") == part_of(vertices, faces.named[face], first[1]), "truth: part is wrong")


def course(claim):
    """The same in the plane or in space."""
    ends = "segment" in claim.input
    what = "segment" if ends else "ray"
    value = claim.input[what]
    if ends:
        one, other = what + "[0]", what + "[1]"
        start, way = list_of_two(value, what)
    else:
        only(value, what, ["origin", "direction"])
        one, other = what + ".origin", what + ".direction"
        start, way = value["origin"], value["direction"]
    start, way = two_or_three(start, one), two_or_three(way, other)
    expect(len(way) == len(start), f"{other}: as many coordinates as {one}")
    expect(ends or any(way), other + ": nonzero direction")
    return start, minus(way, start) if ends else way, ends


def says_hit(claim):
    relation = claim.word("relation")
    expect(relation in ("hit", "none"), "truth: relation is wrong")
    claim.answers("relation", *(["first", "last"] if relation == "hit" else []))
    return relation == "hit"


def inner(p, q):
    return sum(x * y for x, y in zip(p, q))


def expect_beyond(claim, line, highest, radius):
    """Why it proves it stands in check_passages.cpp, also of the next."""
    start, way, ends = line
    claim.expect_kind("separating_plane"), claim.facts("normal")
    normal = claim.list("normal")
    expect(len(normal) == len(start), "certificate: as many coordinates as the line")
    first, slope, reach = inner(normal, start) - highest(normal), inner(normal, way), radius**2 * inner(normal, normal)

    def beyond(height):
        return height > 0 and height**2 > reach

    separates = beyond(first) and (beyond(first + slope) if ends else slope >= 0)
    expect(separates, "certificate: the plane does not separate")


def prove_passage(claim, line, highest, seen, low, high):
    start, way, ends = line
    if not says_hit(claim):
        expect_beyond(claim, line, highest, 0)
        return
    claim.expect_kind("passage"), claim.facts()
    first, last = claim.exact("first"), claim.exact("last")
    base, rates = seen

    def inside_and_leaves(t, direction):
        axes = [(x, direction * v, least, most) for x, v, least, most in zip(along(base, t, rates), rates, low, high)]
        inside = all(least <= x <= most for x, _, least, most in axes)
        return inside, any((v > 0 and x == most) or (v < 0 and x == least) for x, v, least, most in axes)

    inside, leaves = inside_and_leaves(first, -1)
    expect(first >= 0 and inside and (first == 0 or leaves), "truth: first is wrong")
    inside, leaves = inside_and_leaves(last, 1)
    at_end = ends and (last == 1 if any(way) else last == 0)
    in_order = last >= first and (not ends or last <= 1)
    expect(in_order and inside and (at_end or leaves), "truth: last is wrong")


def prove_passage_of_box(claim, name):
    claim.inputs(name, "aabb")
    start, way, ends = course(claim)
    low, high = box(claim.input["aabb"], "aabb")
    expect(len(low) == len(start), f"aabb: as many coordinates as {name}")

    def highest(normal):
        return sum(n * (most if n > 0 else least) for n, least, most in zip(normal, low, high))

    prove_passage(claim, (start, way, ends), highest, (start, way), low, high)


def prove_passage_of_obb(claim, name):
    """The frame is that of check_passages.cpp."""
    claim.inputs(name, "obb")
    start, way, ends = course(claim)
    center, (u, v, w) = solid = obb(claim.input["obb"], "obb")
    expect(len(start) == 3, f"obb: as many coordinates as {name}")
    start, normals = minus(start, center), (cross(v, w), cross(w, u), cross(u, v))
    seen = [tuple(dot(normal, x) for normal in normals) for x in (start, way)]
    high = abs(dot(cross(u, v), w))
    prove_passage(claim, (start, way, ends), lambda normal: reach(solid, normal), seen, [-high] * 3, [high] * 3)


def is_positive(kind, constant, linear, square, ends):
    if constant <= 0:
        return False
    if kind == "receding":
        return linear >= 0
    if kind == "too_late":
        return ends and constant + linear + square > 0 and 2 * square + linear <= 0
    expect(kind == "no_root", WRONG_KIND)
    return 4 * square * constant - linear**2 > 0


def gap_to(line, center, radius):
    start, way, _ = line
    p = minus(start, center)
    return inner(p, p) - radius**2, 2 * inner(p, way), inner(way, way)


def prove_first_and_last(claim, line, at):
    """Why it proves it stands in check_passages.cpp, also of the next."""
    _, way, ends = line
    claim.expect_kind("passage"), claim.facts()
    first, last = exact_surd(claim.truth["first"], "truth.first"), exact_surd(claim.truth["last"], "truth.last")

    def value(t, direction):
        constant, linear, square = at(t, direction)
        return (t.square() * square + t * linear + constant).sign()

    def is_zero(t, direction):
        _, linear, square = at(t, direction)
        return square > 0 and value(t, direction) == 0 and (t * (2 * square) + linear).sign() * direction >= 0

    def is_on_line(t):
        return t.sign() >= 0 and (not ends or (t + -1).sign() <= 0)

    starts_inside = first.sign() == 0 and value(first, 1) <= 0
    is_first = any(way) and first.sign() > 0 and is_on_line(first) and is_zero(first, -1)
    expect(starts_inside or is_first, "truth: first is wrong")
    ends_inside = ends and (last + -1).sign() == 0 and value(last, 1) <= 0
    is_last = ends_inside or (is_on_line(last) and is_zero(last, 1))
    expect(is_last if any(way) else last.sign() == 0, "truth: last is wrong")


def prove_passage_of_ball(claim, name):
    claim.inputs(name, "sphere")
    line = course(claim)
    center, radius = ball_or_disc(claim.input["sphere"], "sphere")
    expect(len(center) == len(line[0]), f"sphere: as many coordinates as {name}")
    f = gap_to(line, center, radius)
    if says_hit(claim):
        prove_first_and_last(claim, line, lambda t, direction: f)
        return
    kind = claim.kind()
    claim.facts()
    expect(is_positive(kind, *f, line[2]), "certificate: the kind does not hold")


def prove_passage_of_capsule(claim, name):
    claim.inputs(name, "capsule")
    start, way, _ = line = course(claim)
    (a, b), radius = capsule_in_space(claim.input["capsule"], "capsule")
    expect(len(start) == 3, f"capsule: as many coordinates as {name}")
    axis = minus(b, a)
    place, climb, length = inner(minus(start, a), axis), inner(way, axis), inner(axis, axis)
    at_a, at_b = gap_to(line, a, radius), gap_to(line, b, radius)
    along_axis = place**2, 2 * place * climb, climb**2
    between = tuple(length * x - y for x, y in zip(at_a, along_axis))

    def at(t, direction):
        along, rises = t * climb + place, climb * direction
        over_a, over_b = along.sign(), (along + -length).sign()
        if length == 0 or over_a < 0 or (over_a == 0 and rises < 0):
            return at_a
        return at_b if over_b > 0 or (over_b == 0 and rises > 0) else between

    if says_hit(claim):
        prove_first_and_last(claim, line, at)
    else:
        expect_beyond(claim, line, lambda normal: max(inner(normal, a), inner(normal, b)), radius)


def check_ray_aabb(claim):
    prove_passage_of_box(claim, "ray")


def check_segment_aabb(claim):
    prove_passage_of_box(claim, "segment")


def check_ray_obb(claim):
    prove_passage_of_obb(claim, "ray")


def check_segment_obb(claim):
    prove_passage_of_obb(claim, "segment")


def check_ray_sphere(claim):
    prove_passage_of_ball(claim, "ray")


def check_segment_sphere(claim):
    prove_passage_of_ball(claim, "segment")


def check_ray_capsule(claim):
    prove_passage_of_capsule(claim, "ray")


def check_segment_capsule(claim):
    prove_passage_of_capsule(claim, "segment")
