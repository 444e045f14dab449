# SPDX-License-Identifier: Apache-2.0
"""The second truths of volumes of intervals around points, boxes and k-DOPs, for simplest_truth.py: each takes an input
as it stands in a claim and gives the answer and the margin."""
from simplest_truth_reading import dot, minus, number, point


def truth_aabb_of_points(q):
    """On each axis the number of which no other is less, and that of which none is greater: every one against all."""
    axes = list(zip(*map(point, q["points"])))
    low = [next(x for x in numbers if all(x <= y for y in numbers)) for numbers in axes]
    high = [next(x for x in numbers if all(x >= y for y in numbers)) for numbers in axes]
    return {"aabb": {"min": list(map(str, low)), "max": list(map(str, high))}}, None


def truth_point_in_kdop(q):
    """The foot of the perpendicular on either plane of a slab is that point of the plane; the point is on the inner
    side where the way there goes along the normal, or against it. Margin: the shortest way, or the longest that leads
    in."""
    p, ways = point(q["point"]), []
    for normal, slab in zip(q["kdop"]["normals"], q["kdop"]["slabs"]):
        n = point(normal)
        for end, inwards in zip(map(number, slab), (-1, 1)):
            share = (end - dot(n, p)) / dot(n, n)
            foot = tuple(x + share * k for x, k in zip(p, n))
            way = minus(foot, p)
            inner = dot(way, n) * inwards
            ways.append(dot(way, way) * (1 if inner > 0 else -1 if inner < 0 else 0))
    least = min(ways)
    return {"location": "inside" if least > 0 else "outside" if least < 0 else "boundary"}, abs(least)


def truth_kdop_kdop(q):
    """One of the four ends of two slabs, or of the numbers halfway between neighbours, is in both slabs, or none is; and
    inside both. Margin: how little an end of a slab has to be moved, alone, for the least overlap to change."""
    pairs = [tuple(map(number, s + t)) for s, t in zip(q["a"]["slabs"], q["b"]["slabs"])]

    def tried(ends):
        ascending = sorted(ends)
        return ascending + [(x + y) / 2 for x, y in zip(ascending, ascending[1:])]

    meet = all(any(a <= x <= b and c <= x <= d for x in tried((a, b, c, d))) for a, b, c, d in pairs)
    inside = all(any(a < x < b and c < x < d for x in tried((a, b, c, d))) for a, b, c, d in pairs)
    least = min(high - low for a, b, c, d in pairs for high in (b, d) for low in (a, c))
    return {"contact": "overlapping" if inside else "touching" if meet else "disjoint"}, abs(least)


def truth_kdop_of_points(q):
    """Takes the least and the greatest of all N . P."""
    slabs = []
    for normal in map(point, q["normals"]):
        values = [dot(normal, point(p)) for p in q["points"]]
        low = next(x for x in values if not any(y < x for y in values))
        slabs.append([str(low), str(next(x for x in values if not any(y > x for y in values)))])
    return {"slabs": slabs}, None
