# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of polyhedra: one function an operation, as in check_polyhedra.cpp."""

from collections import Counter

from certify_meshes import height, mesh, outward_planes
from certify_reading import expect
from certify_space import cross, dot, point_in_space, triple
from certify_sums import over_one


def index(value, count):
    expect(value.denominator == 1 and 0 <= value < count, "certificate: not an index")
    return int(value)


def check_point_in_convex_polyhedron(claim):
    claim.inputs("mesh", "point")
    vertices, faces = mesh(claim.input["mesh"], "mesh")
    p = point_in_space(claim.input["point"], "point")
    planes = outward_planes(vertices, faces, "mesh")
    claim.answers("location")
    if claim.kind() == "separating_face":
        claim.facts("face")
        plane = planes[index(claim.single("face"), len(planes))]
        expect(height(plane, p) > 0, "certificate: the face does not separate")
        expect(claim.word("location") == "outside", "truth: location is wrong")
        return
    claim.expect_kind("barycentric"), claim.facts("corners", "weights")
    corners, weights = claim.list("corners"), claim.list("weights")
    expect(len(corners) == len(weights) == 4, "certificate: four corners and their weights")
    combination = (0, 0, 0)
    for corner, weight in zip(corners, weights):
        expect(weight >= 0, "certificate: a weight is negative")
        vertex = vertices[index(corner, len(vertices))]
        combination = tuple(c + weight * v for c, v in zip(combination, vertex))
    expect(sum(weights) == 1 and combination == p, "certificate: the weights give another point")
    on = any(height(plane, p) == 0 for plane in planes)
    expect(claim.word("location") == ("boundary" if on else "inside"), "truth: location is wrong")


def expect_even(faces, what):
    """Every edge, a pair of vertices in whichever order, is in an even number of faces."""
    edges = [[(a, b), (b, c), (c, a)] for a, b, c in faces]
    times = Counter(frozenset(edge) for of_face in edges for edge in of_face)
    for i, of_face in enumerate(edges):
        for a, b in of_face:
            edge = f"the edge from vertex {a} to vertex {b}"
            even = times[frozenset((a, b))] % 2 == 0
            expect(even, f"{what}.faces[{i}]: closed: {edge} must be in an even number of faces")


def crossing(corners, direction):
    """t > 0, or None: why that is so stands in check_polyhedra.cpp."""
    sides, none = [], (0, 0, 0)
    for a, b in zip(corners, corners[1:] + corners[:1]):
        span = cross(a, b)
        sides.append(dot(direction, span))
        away = span == none and dot(a, b) > 0 and cross(direction, a) != none
        expect(sides[-1] != 0 or away, "certificate: the ray's line meets an edge")
    if not (all(side > 0 for side in sides) or all(side < 0 for side in sides)):
        return None
    t = dot(corners[0], cross(corners[1], corners[2])) / sum(sides)
    expect(t != 0, "certificate: the point is on a face")
    return t if t > 0 else None


def check_point_in_polyhedron(claim):
    claim.inputs("mesh", "point")
    vertices, faces = mesh(claim.input["mesh"], "mesh")
    p = point_in_space(claim.input["point"], "point")
    expect_even(faces, "mesh")
    claim.answers("location")
    if claim.kind() == "on_face":
        claim.facts("face", "weights")
        face = faces[index(claim.single("face"), len(faces))]
        weights = claim.list("weights")
        expect(len(weights) == 3, "certificate: three weights")
        combination = (0, 0, 0)
        for corner, weight in zip(face, weights):
            expect(weight >= 0, "certificate: a weight is negative")
            combination = tuple(c + weight * v for c, v in zip(combination, vertices[corner]))
        expect(sum(weights) == 1 and combination == p, "certificate: the weights give another point")
        expect(claim.word("location") == "boundary", "truth: location is wrong")
        return
    claim.expect_kind("crossings"), claim.facts("direction", "faces", "t")
    direction, scale = over_one(triple(claim, "direction"))
    seen = [tuple(x - y for x, y in zip(vertex, p)) for vertex in vertices]
    crossed = [(i, t * scale) for i, face in enumerate(faces)
               if (t := crossing([seen[corner] for corner in face], direction)) is not None]
    same = claim.list("faces") == [i for i, _ in crossed] and claim.list("t") == [t for _, t in crossed]
    expect(same, "certificate: the ray crosses other faces")
    expect(claim.word("location") == ("inside" if len(crossed) % 2 == 1 else "outside"), "truth: location is wrong")
