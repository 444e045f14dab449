# SPDX-License-Identifier: Apache-2.0
"""Solids within closed meshes, convex or not, as in check_solids.cpp."""

from collections import Counter

from certify_reading import expect
from certify_space import cross, dot, triple
from certify_sums import over_one


def index(value, count):
    expect(value.denominator == 1 and 0 <= value < count, "certificate: not an index")
    return int(value)


def expect_even(faces, what):
    """Every edge, a pair of vertices in whichever order, is in an even number of faces."""
    times = Counter(frozenset(edge) for a, b, c in faces for edge in ((a, b), (b, c), (c, a)))
    for i, corners in enumerate(faces.named):
        for a, b in zip(corners, corners[1:] + corners[:1]):
            edge = f"the edge from vertex {a} to vertex {b}"
            even = times[frozenset((a, b))] % 2 == 0
            expect(even, f"{what}.faces[{i}]: closed: {edge} must be in an even number of faces")


def crossing(corners, direction):
    """t > 0, or None: why that is so stands in check_solids.cpp."""
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


def from_weights(proof, corners):
    """The point of a triangle that the weights of the certificate give."""
    weights = proof.list("weights")
    expect(len(weights) == 3, "certificate: three weights")
    expect(all(weight >= 0 for weight in weights), "certificate: a weight is negative")
    expect(sum(weights) == 1, "certificate: the weights give another point")
    return tuple(dot(weights, along_axis) for along_axis in zip(*corners))


def proved_location(proof, vertices, faces, p):
    if proof.kind() == "on_face":
        proof.facts("face", "weights")
        face = faces[index(proof.single("face"), len(faces))]
        there = from_weights(proof, [vertices[corner] for corner in face]) == p
        expect(there, "certificate: the weights give another point")
        return "boundary"
    proof.expect_kind("crossings"), proof.facts("direction", "faces", "t")
    direction, scale = over_one(triple(proof, "direction"))
    seen = [tuple(x - y for x, y in zip(vertex, p)) for vertex in vertices]
    crossed = [(i, t * scale) for i, face in enumerate(faces)
               if (t := crossing([seen[corner] for corner in face], direction)) is not None]
    same = proof.list("faces") == [i for i, _ in crossed] and proof.list("t") == [t for _, t in crossed]
    expect(same, "certificate: the ray crosses other faces")
    return "inside" if len(crossed) % 2 == 1 else "outside"
