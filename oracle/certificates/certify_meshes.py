# SPDX-License-Identifier: Apache-2.0
"""What the checks of polyhedra share, as in check_meshes.cpp."""

from collections import Counter

from certify_reading import expect, only
from certify_space import dot, point_in_space


def corners(value, what, vertices):
    expect(isinstance(value, list) and len(value) == 3, what + ": a list of three")
    for k, corner in enumerate(value):
        there = isinstance(corner, int) and not isinstance(corner, bool) and 0 <= corner < vertices
        expect(there, f"{what}[{k}]: index of a vertex")
    expect(len(set(value)) == 3, what + ": three different vertices")
    return tuple(value)


def mesh(value, what):
    only(value, what, ["vertices", "faces"])
    for name in ("vertices", "faces"):
        expect(isinstance(value[name], list), f"{what}.{name}: a list")
    vertices = [point_in_space(vertex, f"{what}.vertices[{i}]") for i, vertex in enumerate(value["vertices"])]
    faces = [corners(face, f"{what}.faces[{i}]", len(vertices)) for i, face in enumerate(value["faces"])]
    expect(len(faces) >= 4, what + ": at least 4 faces")
    return vertices, faces


def expect_closed(faces):
    times = Counter(edge for a, b, c in faces for edge in ((a, b), (b, c), (c, a)))
    for (a, b), count in times.items():
        expect(count == 1 and times.get((b, a)) == 1, "truth: the mesh is not closed")


def plane_through(a, b, c):
    (ux, uy, uz), (vx, vy, vz) = ([p[k] - a[k] for k in range(3)] for p in (b, c))
    normal = (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)
    return normal, -dot(normal, a)


def height(plane, p):
    return dot(plane[0], p) + plane[1]


def outward_planes(vertices, faces):
    expect_closed(faces)
    planes, front, back = [], False, False
    for face in faces:
        plane = plane_through(*(vertices[corner] for corner in face))
        planes.append(plane)
        expect(plane[0] != (0, 0, 0), "truth: a face has no area")
        heights = [height(plane, vertex) for vertex in vertices]
        expect(any(heights), "truth: all vertices are on one plane")
        front, back = front or max(heights) > 0, back or min(heights) < 0
        expect(not (front and back), "truth: the mesh is not convex")
    return [(tuple(-n for n in normal), -offset) for normal, offset in planes] if front else planes
