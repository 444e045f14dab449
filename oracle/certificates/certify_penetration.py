# SPDX-License-Identifier: Apache-2.0
"""The check of certify.py for penetration, as in check_penetration.cpp."""

from fractions import Fraction

from certify_meshes import Triangles, listed_faces, mesh, outward_planes
from certify_reading import expect, number, only
from certify_solids import index
from certify_space import cross, dot, list_of_three, minus
from certify_surd import exact_surd


def sign_of(x):
    return (x > 0) - (x < 0)


class Farthest:
    """The indices of the vertices that are farthest along a direction, in ascending order, and their height."""

    def __init__(self, vertices, direction):
        heights = [dot(direction, p) for p in vertices]
        self.height = max(heights)
        self.level = [i for i, height in enumerate(heights) if height == self.height]

    def part(self, vertices):
        spans = [minus(vertices[i], vertices[self.level[0]]) for i in self.level]
        edge = next((span for span in spans if any(span)), None)
        if edge is None:
            return "vertex"
        return "face" if any(any(cross(edge, span)) for span in spans) else "edge"


class Reach:
    """b reaches along the direction beyond the beginning of a by height / |direction|."""

    def __init__(self, a, b, direction):
        self.direction, self.square = direction, dot(direction, direction)
        self.of_a, self.of_b = Farthest(a, tuple(-x for x in direction)), Farthest(b, direction)
        self.height = self.of_a.height + self.of_b.height

    def levels(self):
        return self.of_a.level, self.of_b.level


def weighted(claim, fact, points):
    weights = claim.list(fact)
    expect(len(weights) == len(points), "certificate: as many weights as points")
    for weight in weights:
        expect(weight >= 0, "certificate: a weight is negative")
    expect(sum(weights) == 1, "certificate: the weights do not add up to 1")
    return tuple(sum(w * x for w, x in zip(weights, axis)) for axis in zip(*points))


def hull_of_differences(claim, a, b):
    of_a, of_b, corners = claim.list("of_a"), claim.list("of_b"), claim.list("faces")
    expect(len(of_a) == len(of_b), "certificate: as many vertices of both")
    expect(corners and len(corners) % 3 == 0, "certificate: three corners of each face")
    vertices = []
    for i, j in zip(of_a, of_b):
        end = b[index(j, len(b))]
        vertices.append(minus(end, a[index(i, len(a))]))
    places = [index(corner, len(vertices)) for corner in corners]
    faces = [tuple(places[k:k + 3]) for k in range(0, len(places), 3)]
    return vertices, Triangles(faces, faces)


def nearest_face(claim, a, b):
    """Why it is the truth's stands in check_penetration.cpp."""
    faces = []
    for normal, offset in outward_planes(*hull_of_differences(claim, a, b), "certificate"):
        faces.append(Reach(a, b, normal))
        expect(faces[-1].height == -offset, "certificate: a difference is beyond a face")
        expect(offset <= 0, "certificate: the origin is outside")
    found = faces[index(claim.single("face"), len(faces))]
    for other in faces:
        here, there = other.height**2 * found.square, found.height**2 * other.square
        expect(here >= there, "certificate: a face is nearer")
        first = here > there or found.levels() <= other.levels()
        expect(first, "certificate: a face of earlier vertices is as near")
    return found


def last_across(claim, a, b):
    """Why it is the truth's stands in check_penetration.cpp."""
    expect(weighted(claim, "on_a", a) == weighted(claim, "on_b", b), "certificate: two points that are not the same")
    line = normal = none = (0, 0, 0)
    for vertices in (a, b):
        for vertex in vertices:
            span = minus(vertex, vertices[0])
            expect(dot(normal, span) == 0, "certificate: the differences have an inside")
            if not any(line):
                line = span
            elif not any(normal):
                normal = cross(line, span)
    found = none
    one = Fraction(1)
    for axis in ((one, 0, 0), (0, one, 0), (0, 0, one)):
        if any(found):
            break
        if any(normal):
            found = tuple(dot(axis, normal) * n for n in normal)
        else:
            found = cross(line, cross(axis, line)) if any(line) else axis
    return Reach(a, b, found)


def shortest_displacement(claim, a, b):
    x, y = weighted(claim, "on_a", a), weighted(claim, "on_b", b)
    expect(x != y, "certificate: no direction")
    found = Reach(a, b, minus(x, y))
    expect(found.height == -found.square, "certificate: the displacement is longer than its gap")
    return found


def expect_root(name, value, rational, squared, sign):
    """A number p + q sqrt(r): without its rational part it has that square, and that sign or is 0."""
    rest = exact_surd(value, "truth." + name) + -rational
    right = rest.has_square(squared) and rest.sign() * sign >= 0
    expect(right, f"truth: {name} is wrong")


def expect_coordinates(claim, name, direction, rational, squared):
    value = list_of_three(claim.truth[name], "truth." + name)
    for k, n in enumerate(direction):
        expect_root(f"{name}[{k}]", value[k], n * rational, n * n * squared, sign_of(n))


def core(value, what):
    """Vertices and triangles of a solid, or one to three vertices without a face, whose hull it is."""
    if isinstance(value, dict) and value.get("faces") == [] and "cut" not in value:
        found = listed_faces(value, what)
        if 1 <= len(found[0]) <= 3:
            return found
    return mesh(value, what)


def check_penetration(claim):
    claim.inputs("a", "b", "radius_a", "radius_b")
    cores = [(*core(claim.input[name], name), name) for name in ("a", "b")]
    for vertices, faces, name in cores:
        if faces:
            outward_planes(vertices, faces, name)
    a, b = (vertices for vertices, _, _ in cores)
    radii = 0
    for name in ("radius_a", "radius_b"):
        radius = number(claim.input[name], name)
        expect(radius >= 0, name + ": radius >= 0")
        radii += radius
    claim.answers("contact", "depth", "direction", "translation", "feature")
    meeting = claim.kind() == "difference_hull"
    if meeting:
        claim.facts("face", "of_a", "of_b", "faces")
        found = nearest_face(claim, a, b)
    elif claim.kind() == "common_point":
        claim.facts("on_a", "on_b")
        found = last_across(claim, a, b)
    else:
        claim.expect_kind("nearest_points"), claim.facts("on_a", "on_b")
        found = shortest_displacement(claim, a, b)
    of_cores = found.height**2 / found.square
    sign = sign_of(radii + of_cores) if found.height >= 0 else sign_of(radii**2 - of_cores)
    contact = ("disjoint", "touching", "overlapping")[sign + 1]
    expect(claim.word("contact") == contact, "truth: contact is wrong")
    expect_root("depth", claim.truth["depth"], radii, of_cores, sign_of(found.height))
    expect_coordinates(claim, "direction", found.direction, 0, 1 / found.square)
    expect_coordinates(claim, "translation", found.direction, found.height / found.square, radii**2 / found.square)
    only(claim.truth["feature"], "truth.feature", ["a", "b"])
    parts = {"a": found.of_a.part(a), "b": found.of_b.part(b)}
    expect(claim.truth["feature"] == parts, "truth: feature is wrong")
