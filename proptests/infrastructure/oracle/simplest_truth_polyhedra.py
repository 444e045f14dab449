# SPDX-License-Identifier: Apache-2.0
"""The second truth of polyhedra: a convex solid is what lies behind every plane through three vertices that has no
vertex in front. Its faces are not looked at."""
from functools import cache
from itertools import combinations

from simplest_truth_reading import dot, minus, point


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
