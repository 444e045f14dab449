# SPDX-License-Identifier: Apache-2.0
"""The second truths of oriented boxes, for simplest_truth.py. The solid around the origin, or the differences of two
solids, is what lies between the planes that two edges span, as far from the origin as all edges together reach."""
from itertools import combinations

from simplest_truth_polyhedra import cross
from simplest_truth_reading import dot, minus, point

# Operations that have no second truth, and why.
WITHOUT = {
    "obb_of_points": "many boxes are right; certify_bounding_obbs.py proves each in fractions",
}


def edges_of(obb):
    return [point(axis) for axis in obb["half_axes"]]


def beyond(edges, way):
    """How far the way leads beyond the planes: the greatest squared distance, or the least one, negative, from inside;
    in squared units."""
    heights = []
    for e, f in combinations(edges, 2):
        normal = cross(e, f)
        if any(normal):
            height = abs(dot(normal, way)) - sum(abs(dot(normal, edge)) for edge in edges)
            heights.append(height * abs(height) / dot(normal, normal))
    return max(heights)


def truth_point_in_obb(q):
    by = beyond(edges_of(q["obb"]), minus(point(q["point"]), point(q["obb"]["center"])))
    return {"location": "outside" if by > 0 else "inside" if by < 0 else "boundary"}, abs(by)


def truth_obb_obb(q):
    edges = edges_of(q["a"]) + edges_of(q["b"])
    by = beyond(edges, minus(point(q["b"]["center"]), point(q["a"]["center"])))
    return {"contact": "disjoint" if by > 0 else "overlapping" if by < 0 else "touching"}, abs(by)


def truth_aabb_obb(q):
    """The aligned box has edges as long as half of its width, or 0; a box that is flat touches what it meets. Margin:
    the least width too, squared, where they meet."""
    low, high = point(q["aabb"]["min"]), point(q["aabb"]["max"])
    half = [(b - a) / 2 for a, b in zip(low, high)]
    edges = [tuple(h * (k == axis) for k in range(3)) for axis, h in enumerate(half)] + edges_of(q["obb"])
    by = beyond(edges, minus(point(q["obb"]["center"]), tuple(a + h for a, h in zip(low, half))))
    if by > 0:
        return {"contact": "disjoint"}, by
    margin = min(-by, 4 * min(half) ** 2)
    return {"contact": "overlapping" if margin else "touching"}, margin
