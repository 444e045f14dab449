# SPDX-License-Identifier: Apache-2.0
"""Faces of more than three corners and their cut into triangles, as in check_polygon_faces.cpp."""

from collections import Counter

from certify_reading import expect
from certify_space import cross, dot


def sides(ring):
    return zip(ring, ring[1:] + ring[:1])


def bounded_alike(face, triangles):
    """The triangles run along each edge as often as the face does, forth less back."""
    runs = Counter()
    for ring, times in [(triangle, 1) for triangle in triangles] + [(face, -1)]:
        for a, b in sides(ring):
            runs[min(a, b), max(a, b)] += times if a < b else -times
    return not any(runs.values())


class Plane:
    """The plane of three corners that are not on one line, turns as seen from where the triangle is counter-clockwise."""

    def __init__(self, vertices, corners, triangle):
        self.vertices = vertices
        normals = (cross(self.between(corners[0], b), self.between(corners[0], c)) for b in corners for c in corners)
        self.across = next((normal for normal in normals if any(normal)), (0, 0, 0))
        if self.turn(*triangle) < 0:
            self.across = tuple(-n for n in self.across)

    def between(self, a, b):
        return tuple(q - p for p, q in zip(self.vertices[a], self.vertices[b]))

    def turn(self, a, b, c):
        return dot(self.across, cross(self.between(a, b), self.between(a, c)))

    def beside_an_edge(self, triangle, other):
        return any(all(self.turn(a, b, v) <= 0 for v in other) for a, b in sides(triangle))

    def holds(self, triangle, v):
        if any(self.vertices[v] == self.vertices[corner] for corner in triangle):
            return False
        return all(self.turn(a, b, v) >= 0 for a, b in sides(triangle))


def expect_cut(vertices, named, triangles, what):
    """The named faces are planar, and the triangles, those of the first face first, are a valid cut of them."""
    no_cut = what + ".cut: a cut of the faces into triangles"
    first = 0
    for i, face in enumerate(named):
        own = triangles[first:first + len(face) - 2]
        first += len(own)
        if len(face) == 3:
            expect(own[0] == face, no_cut)
            continue
        plane = Plane(vertices, face, own[0])
        planar = all(dot(plane.across, plane.between(face[0], v)) == 0 for v in face)
        expect(planar, f"{what}.faces[{i}]: planar")
        expect(bounded_alike(face, own), no_cut)
        for k, one in enumerate(own):
            expect(all(v in face for v in one), no_cut)
            expect(plane.turn(*one) > 0, no_cut)
            expect(not any(plane.holds(one, v) for v in face), no_cut)
            for other in own[:k]:
                expect(plane.beside_an_edge(one, other) or plane.beside_an_edge(other, one), no_cut)
