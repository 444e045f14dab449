# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for polyhedra, one function for each operation, as in check_polyhedra.cpp."""

from certify_meshes import height, mesh, outward_planes
from certify_reading import expect
from certify_solids import expect_even, index, proved_location
from certify_space import point_in_space


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
