# SPDX-License-Identifier: Apache-2.0
"""The second truths of bounding volumes, for simplest_truth.py: each takes an input as it stands in a claim and
gives the answer and the margin."""
from fractions import Fraction
from itertools import product

from simplest_truth_reading import dot, minus, number, point


def truth_aabb_aabb(q):
    """On each axis the ends of the intervals, and a number between every two neighbours of these, are all that has to
    be tried: a common coordinate, or one inside both, is among them if there is one. Margin: the least difference
    between a max and a min, of all pairs on an axis; an axis where it is negative keeps the boxes apart, one where it
    is 0 keeps their interiors apart."""
    axes = [[number(x) for x in ends] for ends in zip(q["a"]["min"], q["a"]["max"], q["b"]["min"], q["b"]["max"])]

    def tried(ends):
        ascending = sorted(ends)
        return ascending + [(x + y) / 2 for x, y in zip(ascending, ascending[1:])]

    meet = all(any(a <= x <= b and c <= x <= d for x in tried((a, b, c, d))) for a, b, c, d in axes)
    inside = all(any(a < x < b and c < x < d for x in tried((a, b, c, d))) for a, b, c, d in axes)
    least = min(high - low for a, b, c, d in axes for high in (b, d) for low in (a, c))
    return {"contact": "overlapping" if inside else "touching" if meet else "disjoint"}, abs(least)


def truth_sphere_sphere(q):
    """The point that divides the way from center to center as the radii do is in both balls, or nothing is; it is inside
    both, or nothing is. Margin: how far the square of the distance, and that of either radius, is from the square of the
    radii's sum: a radius may become as great as the sum, where the other is 0."""
    p, r, s = point(q["a"]["center"]), number(q["a"]["radius"]), number(q["b"]["radius"])
    way = minus(point(q["b"]["center"]), p)
    share = r / (r + s) if r + s else 0
    beyond = [dot(part, part) - radius * radius for part, radius in (
        (tuple(share * x for x in way), r), (tuple((1 - share) * x for x in way), s))]
    contact = "disjoint" if max(beyond) > 0 else "touching" if max(beyond) == 0 else "overlapping"
    return {"contact": contact}, abs(min((r + s) ** 2 - square for square in (dot(way, way), r * r, s * s)))


def truth_closest_point_on_aabb(q):
    """The nearest point lies inside the box, a face, an edge, or is a corner; there it is the foot of the perpendicular. So
    of the points that have on each axis the coordinate of the point, of min or of max it is the nearest that is in the box."""
    p, low, high = point(q["point"]), point(q["aabb"]["min"]), point(q["aabb"]["max"])
    in_box = [x for x in product(*zip(p, low, high)) if all(a <= y <= b for a, y, b in zip(low, x, high))]
    return {"point": [str(x) for x in min(in_box, key=lambda x: dot(minus(x, p), minus(x, p)))]}, None


def truth_sphere_aabb(q):
    """The point nearest to its center, found as above, decides whether the ball reaches the box; whether it reaches into
    the box, of a box and a ball that have an interior, by the same. Margin: how far the squared distance is from the
    square of the radius, and, where they meet, how wide the box is, squared."""
    p, r = point(q["sphere"]["center"]), number(q["sphere"]["radius"])
    nearest = truth_closest_point_on_aabb({"point": q["sphere"]["center"], "aabb": q["aabb"]})[0]["point"]
    way = minus(tuple(map(Fraction, nearest)), p)
    gap = dot(way, way) - r * r
    width = min(minus(point(q["aabb"]["max"]), point(q["aabb"]["min"])))
    contact = "disjoint" if gap > 0 else "touching" if gap == 0 or width == 0 or r == 0 else "overlapping"
    return {"contact": contact}, gap if gap > 0 else min(-gap, width * width)


def way_from_box(place, edges, center, axes):
    """The displacement between the nearest points of a box and of a point, or from a segment that leads from its middle by an edge and back; place
    is that point or middle. Each coefficient of the nearest points is -1, 1, or such that the displacement is at a right
    angle to its edge: of all that one of these choices makes, with coefficients in [-1, 1], the nearest. A choice whose
    edges are dependent is skipped: others make the nearest points too."""
    edges, way, found = [*axes, *edges], minus(place, center), []
    for choice in product((-1, 0, 1), repeat=len(edges)):
        free = [edge for edge, side in zip(edges, choice) if side == 0]
        rest = minus(way, tuple(sum(side * edge[k] for edge, side in zip(edges, choice)) for k in range(3)))
        shares = solved_equations([[dot(a, b) for b in free] for a in free], [dot(a, rest) for a in free])
        if shares is not None and all(-1 <= share <= 1 for share in shares):
            beyond = minus(rest, tuple(sum(share * edge[k] for share, edge in zip(shares, free)) for k in range(3)))
            found.append(beyond)
    return min(found, key=lambda beyond: dot(beyond, beyond))


def gap_to_box(*shapes):
    """The squared distance."""
    beyond = way_from_box(*shapes)
    return dot(beyond, beyond)


def contact_with_obb(place, edges, obb, radius):
    """Margin: how far the squared distance is from the square of the radius."""
    gap = gap_to_box(place, edges, point(obb["center"]), list(map(point, obb["half_axes"]))) - radius**2
    return {"contact": "disjoint" if gap > 0 else "overlapping" if gap < 0 else "touching"}, abs(gap)


def truth_sphere_obb(q):
    return contact_with_obb(point(q["sphere"]["center"]), [], q["obb"], number(q["sphere"]["radius"]))


def solved_equations(rows, right):
    """Linear equations of a Gram matrix, by elimination; nothing where they are dependent, which makes a pivot 0."""
    rows = [[*row, value] for row, value in zip(rows, right)]
    for k, pivot in enumerate(rows):
        if pivot[k] == 0:
            return None
        pivot[:] = [x / pivot[k] for x in pivot]
        for row in rows[:k] + rows[k + 1:]:
            row[:] = [x - row[k] * y for x, y in zip(row, pivot)]
    return [row[-1] for row in rows]
