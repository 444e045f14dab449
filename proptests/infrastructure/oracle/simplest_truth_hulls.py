# SPDX-License-Identifier: Apache-2.0
"""The second truths of convex hulls, for simplest_truth.py: each takes an input as it stands in a claim and gives the
answer, in the oracle's order, and the margin."""
from simplest_truth_reading import cross, dot, minus, point

# Operations that have no second truth, and why.
WITHOUT = {
    "convex_hull": "many answers are right; certify_hulls.py proves each in integers",
}


def turn(p, q, r):
    return cross(minus(q, p), minus(r, p))


def truth_convex_hull_2d(q):
    """An edge goes from a point to another where every third one is to its left, or between its ends. Margin: the least
    doubled area of an edge and any other point of the list; of two points their squared distance."""
    listed = [point(p) for p in q["points"]]
    points = sorted(set(listed))
    if len(points) == 1:
        return {"dimension": 0, "point": 0}, 0 if len(listed) > 1 else None

    def is_edge(a, b):
        return all(turn(a, b, p) > 0 or (turn(a, b, p) == 0 and dot(minus(p, a), minus(p, b)) <= 0) for p in points)

    following = {a: b for a in points for b in points if a != b and is_edge(a, b)}
    ring = [points[0]]
    while following[ring[-1]] != ring[0]:
        ring.append(following[ring[-1]])
    places = [listed.index(p) for p in ring]
    if len(ring) == 2:
        way = minus(*ring)
        return {"dimension": 1, "segment": places}, dot(way, way) if len(listed) == 2 else 0
    areas = [abs(turn(listed[i], listed[k], p)) for i, k in zip(places, places[1:] + places[:1])
             for m, p in enumerate(listed) if m not in (i, k)]
    return {"dimension": 2, "polygon": places}, min(areas)
