# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for polyhedra, one function for each operation, as in check_polyhedra.cpp."""

from certify_meshes import height, mesh, outward_planes, part_of
from certify_reading import Claim, expect
from certify_solids import expect_even, from_weights, index, proved_location
from certify_space import cross, dot, exact_triple, minus, point_in_space
from certify_surd import exact_surd, expect_distance


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


def check_point_in_polyhedron(claim):
    claim.inputs("mesh", "point")
    vertices, faces = mesh(claim.input["mesh"], "mesh")
    p = point_in_space(claim.input["point"], "point")
    expect_even(faces, "mesh")
    claim.answers("location")
    location = proved_location(claim, vertices, faces, p)
    expect(claim.word("location") == location, "truth: location is wrong")


def along(start, t, step):
    return tuple(x + t * v for x, v in zip(start, step))


def square_to_box(corners, p):
    """The squared distance of a point from the box around a triangle."""
    return sum(max(0, min(on_axis) - x, x - max(on_axis)) ** 2 for x, on_axis in zip(p, zip(*corners)))


def nearest_in(corners, p):
    """Why that is the nearest point of a triangle stands in check_polyhedra.cpp."""
    a, b, c = corners
    normal, nearest = cross(minus(b, a), minus(c, a)), a
    over = any(normal)
    for start, end in ((a, b), (b, c), (c, a)):
        edge = minus(end, start)
        length, foot = dot(edge, edge), dot(minus(p, start), edge)
        x = start if foot <= 0 else along(start, foot / length if foot < length else 1, edge)
        nearest = min(nearest, x, key=lambda y: dot(minus(y, p), minus(y, p)))
        over = over and dot(cross(normal, edge), minus(p, start)) >= 0
    return along(p, dot(minus(a, p), normal) / dot(normal, normal), normal) if over else nearest


def check_point_mesh_distance(claim):
    claim.inputs("point", "mesh")
    p = point_in_space(claim.input["point"], "point")
    vertices, faces = mesh(claim.input["mesh"], "mesh")
    expect_even(faces, "mesh")
    claim.answers("location", "nearest", "squared_distance", "distance", "signed_distance")
    claim.facts("face", "weights", "location")
    proofs = claim.proofs("location")
    expect(len(proofs) == 1, "certificate.location: a list of one")
    location = proved_location(proofs[0], vertices, faces, p)
    expect(claim.word("location") == location, "truth: location is wrong")
    triangles = [[vertices[corner] for corner in face] for face in faces]
    face = index(claim.single("face"), len(faces))
    x = from_weights(claim, triangles[face])
    least = dot(minus(x, p), minus(x, p))
    for i, corners in enumerate(triangles):
        if square_to_box(corners, p) > least:
            continue
        y = nearest_in(corners, p)
        here = dot(minus(y, p), minus(y, p))
        expect(here >= least, "certificate: a face is nearer")
        expect(here > least or (face <= i if x == y else x < y), "certificate: another place comes first")
    expect_distance(claim, least)
    signed = exact_surd(claim.truth["signed_distance"], "truth.signed_distance")
    side = {"inside": -1, "boundary": 0, "outside": 1}[location]
    expect(signed.sign() == side and signed.has_square(least), "truth: signed_distance is wrong")
    nearest = Claim({"input": claim.input, "truth": claim.truth["nearest"], "certificate": claim.certificate})
    nearest.answers("point", "face", "part")
    expect(exact_triple(nearest.truth["point"], "truth.point") == x, "truth: point is wrong")
    named, answered = faces.face_of[face], nearest.truth["face"]
    expect(type(answered) is int and answered == named, "truth: face is wrong")
    expect(nearest.word("part") == part_of(vertices, faces.named[named], x), "truth: part is wrong")
