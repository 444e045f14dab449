# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for moving shapes, one function for each operation, as in check_sweeps.cpp."""

from itertools import product

from certify_meshes import listed_faces
from certify_reading import WRONG_KIND, expect
from certify_space import ball, box_holds, box_in_space, cross, dot, minus, named, plane, point_in_space, triple
from certify_solids import index
from certify_surd import Surd, exact_surd
from certify_triangles import capsule_in_space, points, weighted

NO_PROOF = "certificate: the kind does not hold"


def squared_gap(claim):
    """(C, B, A): |c + t v|^2 - r^2 = C + B t + A t^2 is at most 0 where the balls meet."""
    (p, r), (q, s) = ball(claim.input["a"], "a"), ball(claim.input["b"], "b")
    velocities = [point_in_space(claim.input[name], name) for name in ("velocity_a", "velocity_b")]
    c, v = minus(p, q), minus(*velocities)
    return dot(c, c) - (r + s) ** 2, 2 * dot(c, v), dot(v, v)


def never_zero(kind, constant, linear, square):
    """Why each proves it stands in check_sweeps.cpp."""
    if constant <= 0:
        return False
    if kind == "receding":
        return linear >= 0
    if kind == "too_late":
        return constant + linear + square > 0 and 2 * square + linear <= 0
    expect(kind == "no_root", WRONG_KIND)
    return 4 * square * constant - linear**2 > 0


def prove_first_zero(claim, constant, linear, square):
    relation, kind = claim.word("relation"), claim.kind()
    expect(relation in ("hit", "never"), "truth: relation is wrong")
    claim.facts("polynomial")
    expect(triple(claim, "polynomial") == (constant, linear, square), "certificate: the polynomial is wrong")
    if relation == "never":
        claim.answers("relation")
        expect(never_zero(kind, constant, linear, square), NO_PROOF)
        return
    claim.answers("relation", "t")
    t = exact_surd(claim.truth["t"], "truth.t")
    if kind == "start":
        expect(constant <= 0, NO_PROOF)
        expect(t.sign() == 0, "truth: t is wrong")
        return
    expect(kind == "first_root", WRONG_KIND)
    expect(constant > 0, NO_PROOF)
    zero = (t.square() * square + t * linear + constant).sign() == 0
    first = t.sign() > 0 and (t + -1).sign() <= 0 and zero and (t * (2 * square) + linear).sign() <= 0
    expect(first, "truth: t is wrong")


def check_swept_sphere_sphere(claim):
    claim.inputs("a", "b", "velocity_a", "velocity_b")
    prove_first_zero(claim, *squared_gap(claim))


def prove_approach(claim, normal, e, radius, velocity):
    """Requires the first zero of f = (e + t N . v)^2 - r^2 N . N."""
    rise = dot(normal, velocity)
    prove_first_zero(claim, e * e - radius**2 * dot(normal, normal), 2 * e * rise, rise * rise)


def check_swept_sphere_plane(claim):
    claim.inputs("sphere", "velocity", "plane")
    center, radius = ball(claim.input["sphere"], "sphere")
    velocity = point_in_space(claim.input["velocity"], "velocity")
    normal, offset = plane(claim.input["plane"], "plane")
    prove_approach(claim, normal, dot(normal, center) + offset, radius, velocity)


def check_swept_capsule_plane(claim):
    """Why the nearest point of the segment is enough stands in check_sweeps.cpp."""
    claim.inputs("capsule", "velocity", "plane")
    ends, radius = capsule_in_space(claim.input["capsule"], "capsule")
    velocity = point_in_space(claim.input["velocity"], "velocity")
    normal, offset = plane(claim.input["plane"], "plane")
    a, b = (dot(normal, end) + offset for end in ends)
    prove_approach(claim, normal, 0 if a * b <= 0 else min(a, b, key=abs), radius, velocity)


def expect_contact_on_sides(center, velocity, low, high, radius, sides, t):
    """Why it proves that stands in check_sweeps.cpp."""
    expect(all(side in (-1, 0, 1) for side in sides), "certificate.sides: -1, 0 or 1")
    constant, linear, square = -radius * radius, 0, 0
    comes_in, in_place = False, True
    for c, v, least, greatest, side in zip(center, velocity, low, high, sides):
        to_min, to_max = (t * v + (c - least)).sign(), (t * v + (c - greatest)).sign()
        comes_in = comes_in or (v > 0 and to_min <= 0) or (v < 0 and to_max >= 0)
        in_place = in_place and (to_min <= 0 if side == -1 else to_max >= 0 if side == 1 else to_min >= 0 >= to_max)
        if side != 0:
            gap = c - (least if side < 0 else greatest)
            constant, linear, square = constant + gap * gap, linear + 2 * gap * v, square + v * v
    expect(in_place, "certificate: the center is on other sides at t")
    zero = (t.square() * square + t * linear + constant).sign() == 0
    first = t.sign() > 0 and (t + -1).sign() <= 0 and zero and (t * (2 * square) + linear).sign() <= 0
    expect(first and comes_in, "truth: t is wrong")


def expect_apart(claim, center, radius, velocity, corners):
    n = triple(claim, "normal")
    start = dot(n, center) - max(dot(n, corner) for corner in corners)
    end, reach = start + dot(n, velocity), radius**2 * dot(n, n)
    apart = start > 0 and end > 0 and start**2 > reach and end**2 > reach
    expect(apart, "certificate: the axis does not separate")


def expect_common_point(claim, center, radius, low, high):
    point = triple(claim, "point")
    way = minus(center, point)
    common = box_holds(low, high, point) and dot(way, way) <= radius**2
    expect(common, "certificate: the point is not in both")


def check_swept_sphere_aabb(claim):
    claim.inputs("sphere", "velocity", "aabb")
    center, radius = ball(claim.input["sphere"], "sphere")
    velocity = point_in_space(claim.input["velocity"], "velocity")
    low, high = box_in_space(claim.input["aabb"], "aabb")
    relation, kind = claim.word("relation"), claim.kind()
    if relation == "never":
        claim.answers("relation"), expect(kind == "separating_axis", WRONG_KIND), claim.facts("normal")
        return expect_apart(claim, center, radius, velocity, list(product(*zip(low, high))))
    expect(relation == "hit", "truth: relation is wrong"), claim.answers("relation", "t")
    t = exact_surd(claim.truth["t"], "truth.t")
    if kind == "start":
        claim.facts("point"), expect_common_point(claim, center, radius, low, high)
        return expect(t.sign() == 0, "truth: t is wrong")
    expect(kind == "first_contact", WRONG_KIND), claim.facts("sides")
    return expect_contact_on_sides(center, velocity, low, high, radius, triple(claim, "sides"), t)


def times(factor, vector):
    return tuple(factor * x for x in vector)


def displacement_from(corners, part, center, v):
    """(start, rise, scale, sides), as in check_sweeps.cpp."""
    first = corners[part[0]]
    w = minus(center, first)
    if len(part) == 1:
        return w, v, 1, []
    e = minus(corners[part[1]], first)
    if len(part) == 2:
        square = dot(e, e)
        expect(square > 0, "certificate: the edge has no length")
        start, rise = (minus(times(square, d), times(dot(d, e), e)) for d in (w, v))
        return start, rise, square, [(e, first), (times(-1, e), corners[part[1]])]
    n = cross(e, minus(corners[2], corners[0]))
    expect(dot(n, n) > 0, "certificate: the polygon has no area")
    sides = [(cross(n, minus(p, q)), q) for p, q in zip(corners[1:] + corners[:1], corners)]
    return times(dot(w, n), n), times(dot(v, n), n), dot(n, n), sides


def expect_contact_on_polygon(claim, center, radius, v, corners, t):
    """Why it proves that stands in check_sweeps.cpp."""
    named(claim, "corners", corners)
    part = [int(place) for place in claim.list("corners")]
    expect(part and part == sorted(set(part)), "certificate.corners: in ascending order")
    start, rise, scale, sides = displacement_from(corners, part, center, v)
    over = all((t * dot(n, v) + dot(n, minus(center, p))).sign() >= 0 for n, p in sides)
    ways = [minus(p, corners[part[0]]) for p in corners]
    over = over and all((t * dot(rise, way) + dot(start, way)).sign() <= 0 for way in ways)
    expect(over, "certificate: the center is over another part at t")
    constant, linear, square = dot(start, start) - (radius * scale) ** 2, 2 * dot(start, rise), dot(rise, rise)
    m = triple(claim, "normal")
    heights = [(t * (dot(m, rise) - scale * dot(m, v)) + (scale * dot(m, minus(p, center)) + dot(m, start))).sign()
               for p in corners]
    leaves = dot(m, v) > 0 and min(heights) >= 0
    slope = (t * (2 * square) + linear).sign()
    first = t.sign() > 0 and (t + -1).sign() <= 0 and (t.square() * square + t * linear + constant).sign() == 0
    expect(first and (slope < 0 or slope == 0 and leaves), "truth: t is wrong")


def expect_hit(claim, center, radius, velocity, corners, t):
    """Requires that t is the first contact, by a common point at the start or the part that is met later."""
    if claim.kind() != "start":
        claim.expect_kind("first_contact")
        return expect_contact_on_polygon(claim, center, radius, velocity, corners, t)
    weights = claim.list("weights")
    expect(len(weights) == len(corners), "certificate: as many weights as points")
    way = minus(center, weighted(corners, weights))
    expect(dot(way, way) <= radius**2, "certificate: the point is not in both")
    expect(t.sign() == 0, "truth: t is wrong")


def prove_contact_with_polygon(claim, center, radius, velocity, corners):
    """A moving ball and a convex polygon at rest, its corners in order."""
    relation, kind = claim.word("relation"), claim.kind()
    if relation == "never":
        claim.answers("relation"), expect(kind == "separating_axis", WRONG_KIND), claim.facts("normal")
        return expect_apart(claim, center, radius, velocity, corners)
    expect(relation == "hit", "truth: relation is wrong"), claim.answers("relation", "t")
    t = exact_surd(claim.truth["t"], "truth.t")
    if kind == "start":
        claim.facts("weights")
    else:
        claim.expect_kind("first_contact"), claim.facts("corners", "normal")
    expect_hit(claim, center, radius, velocity, corners, t)


def check_swept_sphere_triangle(claim):
    claim.inputs("sphere", "velocity", "triangle")
    center, radius = ball(claim.input["sphere"], "sphere")
    velocity = point_in_space(claim.input["velocity"], "velocity")
    corners = points(claim.input["triangle"], "triangle", 3, "three")
    prove_contact_with_polygon(claim, center, radius, velocity, corners)


def check_swept_sphere_mesh(claim):
    claim.inputs("sphere", "velocity", "mesh")
    center, radius = ball(claim.input["sphere"], "sphere")
    velocity = point_in_space(claim.input["velocity"], "velocity")
    vertices, faces = listed_faces(claim.input["mesh"], "mesh")
    relation = claim.word("relation")
    expect(relation in ("hit", "never"), "truth: relation is wrong")
    claim.answers("relation", *(["t", "face"] if relation == "hit" else []))
    claim.expect_kind("faces"), claim.facts("missed", "met")
    proved, first = set(), None

    def corners_of(value):
        face = index(value, len(faces))
        expect(face not in proved, "certificate: a face is proved twice")
        proved.add(face)
        return [vertices[corner] for corner in faces[face]]

    for proof in claim.proofs("missed"):
        proof.expect_kind("separating_axis"), proof.facts("normal", "faces")
        for face in proof.list("faces"):
            expect_apart(proof, center, radius, velocity, corners_of(face))
    for proof in claim.proofs("met"):
        if proof.kind() == "start":
            proof.facts("face", "weights", "time")
        else:
            proof.expect_kind("first_contact"), proof.facts("face", "corners", "normal", "time")
        time = triple(proof, "time")
        expect(time[2] >= 0, "certificate.time: the root of a negative number")
        t, face = Surd(*time), proof.single("face")
        expect_hit(proof, center, radius, velocity, corners_of(face), t)
        order = t.compared_with(first[0]) if first else -1
        if order < 0 or order == 0 and face < first[1]:
            first = t, face
    expect(len(proved) == len(faces), "certificate: a face is left out")
    expect(relation == ("hit" if first else "never"), "truth: relation is wrong")
    if first:
        expect(exact_surd(claim.truth["t"], "truth.t").compared_with(first[0]) == 0, "truth: t is wrong")
        face = claim.truth["face"]
        named = faces.face_of[index(first[1], len(faces))]
        expect(type(face) is int and face == named, "truth: face is wrong")


def check_swept_capsule_capsule(claim):
    """Why the points of b, less the displacements along a, are enough stands in check_sweeps.cpp."""
    claim.inputs("a", "b", "velocity")
    (p, q), r = capsule_in_space(claim.input["a"], "a")
    of_b, s = capsule_in_space(claim.input["b"], "b")
    velocity, u = point_in_space(claim.input["velocity"], "velocity"), minus(q, p)
    corners = [*of_b, minus(of_b[1], u), minus(of_b[0], u)]
    prove_contact_with_polygon(claim, p, r + s, velocity, corners)
