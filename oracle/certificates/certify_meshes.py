# SPDX-License-Identifier: Apache-2.0
"""Shared parts of the checks of polyhedra, as in check_meshes.cpp."""

from collections import Counter

from certify_polygon_faces import expect_cut
from certify_reading import expect, only
from certify_space import cross, dot, minus, point_in_space


def corners(value, what, vertices):
    expect(isinstance(value, list) and len(value) >= 3, what + ": at least 3 corners")
    for k, corner in enumerate(value):
        there = isinstance(corner, int) and not isinstance(corner, bool) and 0 <= corner < vertices
        expect(there, f"{what}[{k}]: index of a vertex")
    return tuple(value)


def faces_of(value, what, vertices):
    expect(isinstance(value, list), what + ": a list")
    return [corners(face, f"{what}[{i}]", vertices) for i, face in enumerate(value)]


class Triangles(list):
    """Those of the first face first; `face_of` tells which face each is a part of, `named` the faces as they are named."""

    def __init__(self, triangles, named):
        super().__init__(triangles)
        self.face_of = [i for i, face in enumerate(named) for _ in face[2:]]
        self.named = named


def is_cut(value):
    return isinstance(value, dict) and "cut" in value


def listed(value, what):
    """Vertices, triangles and faces as they are listed."""
    cut = is_cut(value)
    only(value, what, ["vertices", "faces"] + cut * ["cut"])
    expect(isinstance(value["vertices"], list), what + ".vertices: a list")
    vertices = [point_in_space(vertex, f"{what}.vertices[{i}]") for i, vertex in enumerate(value["vertices"])]
    named = faces_of(value["faces"], what + ".faces", len(vertices))
    triangles = faces_of(value["cut"], what + ".cut", len(vertices)) if cut else named
    in_threes = all(len(triangle) == 3 for triangle in triangles)
    expect(in_threes, what + (".cut: lists of three" if cut else ".faces: lists of three, or a cut"))
    if cut:
        enough = len(triangles) == sum(len(face) - 2 for face in named)
        expect(enough, what + ".cut: a cut of the faces into triangles")
    return vertices, triangles, named


def part_of(vertices, corners, x):
    """The place of a point of a face in it, with any number of corners."""
    seen = [minus(x, vertices[corner]) for corner in corners]
    if (0, 0, 0) in seen:
        return "vertex"
    on_edge = any(cross(v, w) == (0, 0, 0) and dot(v, w) <= 0 for v, w in zip(seen, seen[1:] + seen[:1]))
    return "edge" if on_edge else "inside"


def listed_faces(value, what):
    """Vertices and triangles of any number of faces, of which one of three corners may use a vertex twice."""
    vertices, triangles, named = listed(value, what)
    if is_cut(value):
        expect_cut(vertices, named, triangles, what)
    return vertices, Triangles(triangles, named)


def named_mesh(value, what):
    """Vertices, triangles, and the faces as they are named, which may have more than three corners."""
    vertices, triangles = listed_faces(value, what)
    named = triangles.named
    for i, face in zip(triangles.face_of, triangles):
        expect(len(set(face)) == 3, f"{what}.faces[{i}]: three different vertices")
    expect(len(named) >= 4, what + ": at least 4 faces")
    return vertices, triangles, named


def mesh(value, what):
    """Vertices and triangles."""
    return named_mesh(value, what)[:2]


def expect_closed(faces, what):
    times = Counter(edge for a, b, c in faces for edge in ((a, b), (b, c), (c, a)))
    for i, face in zip(faces.face_of, faces):
        for a, b in zip(face, face[1:] + face[:1]):
            matched = times[(a, b)] == 1 and times.get((b, a)) == 1
            expect(matched, f"{what}.faces[{i}]: closed: edge {a} -> {b} must occur once, and {b} -> {a} once")


def plane_through(a, b, c):
    (ux, uy, uz), (vx, vy, vz) = ([p[k] - a[k] for k in range(3)] for p in (b, c))
    normal = (uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)
    return normal, -dot(normal, a)


def height(plane, p):
    return dot(plane[0], p) + plane[1]


def outward_planes(vertices, faces, what):
    expect_closed(faces, what)
    planes = [plane_through(*(vertices[corner] for corner in face)) for face in faces]
    for i, (normal, _) in zip(faces.face_of, planes):
        expect(normal != (0, 0, 0), f"{what}.faces[{i}]: nonzero area")
    front = next((above for above in (height(planes[0], vertex) for vertex in vertices) if above), 0)
    expect(front != 0, what + ": convex: vertices on one plane have no inside")
    if front > 0:
        planes = [(tuple(-n for n in normal), -offset) for normal, offset in planes]
    for i, plane in zip(faces.face_of, planes):
        for v, vertex in enumerate(vertices):
            inside = height(plane, vertex) <= 0
            expect(inside, f"{what}.faces[{i}]: convex: vertex {v} must not lie beyond its plane")
    return planes
