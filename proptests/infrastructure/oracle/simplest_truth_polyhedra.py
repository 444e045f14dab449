# SPDX-License-Identifier: Apache-2.0
"""The second truth of polyhedra: a convex solid is what lies behind every plane through three vertices that has no
vertex in front. Its faces are not looked at. A point is inside of any other solid if an odd number of its faces make
with one point far away, in no plane with the point and an edge, a tetrahedron that holds it."""
from fractions import Fraction
from functools import cache
from itertools import combinations, count
from math import lcm

from simplest_truth_reading import dot, minus, point, triangles

WITHOUT = {
    "polyhedron_polyhedron": "fractions take too long; nef_solids.cpp compares it with CGAL's Nef polyhedra",
}


def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


@cache
def supporting_planes(vertices):
    """(normal, a vertex) of every plane through three vertices that has none in front, but for repetitions."""
    vertices = sorted({tuple(int(x) if x == int(x) else x for x in v) for v in vertices})  # integers are quicker
    planes = []
    for a, b, c in combinations(vertices, 3):
        normal = cross(minus(b, a), minus(c, a))
        for side in (normal, tuple(-n for n in normal)):
            if any(side) and all(dot(side, minus(v, a)) <= 0 for v in vertices):
                planes.append((side, a))
    return planes


def truth_point_in_convex_polyhedron(question):
    p = point(question["point"])
    planes = supporting_planes(tuple(point(v) for v in question["mesh"]["vertices"]))
    heights = [(dot(normal, minus(p, a)), dot(normal, normal)) for normal, a in planes]
    if max(height for height, _ in heights) > 0:
        return {"location": "outside"}, max(height**2 / square for height, square in heights if height > 0)
    distance = min(height**2 / square for height, square in heights)
    return {"location": "boundary" if distance == 0 else "inside"}, distance


def volume(a, b, c, d):
    return dot(minus(b, a), cross(minus(c, a), minus(d, a)))


def squared_distance_of_edge(p, a, b):
    along, square = minus(b, a), dot(minus(b, a), minus(b, a))
    t = dot(minus(p, a), along)
    if t <= 0 or t >= square:
        return min(dot(minus(p, end), minus(p, end)) for end in (a, b))
    return dot(minus(p, a), minus(p, a)) - Fraction(t * t, square)


def squared_distance_of_face(p, corners):
    """To the plane, if the foot is on the inner side of each edge; else to an edge."""
    a, b, c = corners
    normal, edges = cross(minus(b, a), minus(c, a)), [(a, b), (b, c), (c, a)]
    if any(normal) and all(dot(cross(normal, minus(v, u)), minus(p, u)) >= 0 for u, v in edges):
        return Fraction(dot(normal, minus(p, a)) ** 2, dot(normal, normal))
    return min(squared_distance_of_edge(p, u, v) for u, v in edges)


def in_no_plane(faces, p, apex):
    return all(volume(apex, p, u, v) != 0 or not any(cross(minus(u, p), minus(v, p)))
               for a, b, c in faces for u, v in ((a, b), (b, c), (c, a)))


def holds(corners, p):
    whole = volume(*corners)
    return whole != 0 and all(
        volume(*(p if i == k else corner for i, corner in enumerate(corners))) * whole > 0 for k in range(4))


def truth_point_in_polyhedron(question):
    mesh, given = question["mesh"], [point(v) for v in [question["point"], *question["mesh"]["vertices"]]]
    scale = lcm(*(x.denominator for v in given for x in v))  # integers are quicker
    p, *vertices = (tuple(int(x * scale) for x in v) for v in given)
    faces = [tuple(vertices[i] for i in face) for face in triangles(mesh)]
    margin = min(squared_distance_of_face(p, face) for face in faces) / Fraction(scale**2)
    if margin == 0:
        return {"location": "boundary"}, margin
    far = 1 + 2 * max(abs(x) for v in [p, *vertices] for x in v)
    candidates = ((-far * k, far * (k * k + 1), -far * (k**3 + 2)) for k in count(1))
    apex = next(apex for apex in candidates if in_no_plane(faces, p, apex))
    inside = sum(holds((apex, *face), p) for face in faces) % 2 == 1
    return {"location": "inside" if inside else "outside"}, margin
