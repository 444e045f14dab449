# SPDX-License-Identifier: Apache-2.0
"""The second truths of segments and triangles of space: half-spaces cut the segment, distances by all feet; what two
triangles have in common is spanned by what their edges have in common with the other."""
from fractions import Fraction
from itertools import combinations

from simplest_truth_polyhedra import cross
from simplest_truth_reading import cut, cut_to_zero, dot, minus, point


def at(ends, t):
    return tuple(a + t * (b - a) for a, b in zip(*ends))


def written(p):
    return [str(x) for x in p]


def common_interval(ends, corners):
    """The t of [0, 1] at which the segment is in the triangle: within its plane and edges, or, where it has no area,
    on its line and between the corners that are farthest apart, which may be one."""
    start, along = ends[0], minus(ends[1], ends[0])
    interval = (Fraction(0), Fraction(1))
    normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))

    def keep(cutter, direction, corner):
        return cutter(interval, dot(direction, along), dot(direction, minus(start, corner)))

    if any(normal):
        interval = keep(cut_to_zero, normal, corners[0])
        for i in range(3):
            edge = minus(corners[(i + 1) % 3], corners[i])
            interval = keep(cut, cross(normal, edge), corners[i])
        return interval
    first, last = max(combinations(corners, 2), key=lambda pair: dot(minus(*pair), minus(*pair)))
    edge = minus(last, first)
    for axis in ((1, 0, 0), (0, 1, 0), (0, 0, 1)):
        interval = keep(cut_to_zero, cross(edge, axis) if any(edge) else axis, first)
    interval = keep(cut, edge, first)
    return keep(cut, minus(first, last), last)


def squared_distance_from_segment(p, ends):
    along = minus(ends[1], ends[0])
    foot = dot(minus(p, ends[0]), along) / dot(along, along) if any(along) else Fraction(0)
    way = minus(p, at(ends, min(max(foot, Fraction(0)), Fraction(1))))
    return dot(way, way)


def squared_distance_of_segments(s, r):
    distances = [squared_distance_from_segment(p, r) for p in s] + [squared_distance_from_segment(p, s) for p in r]
    u, v, w = minus(s[1], s[0]), minus(r[1], r[0]), minus(r[0], s[0])
    # Least |w + j v - i u|^2: both derivatives are 0.
    uu, uv, vv = dot(u, u), dot(u, v), dot(v, v)
    whole = uu * vv - uv * uv
    if whole != 0:
        i, j = (vv * dot(w, u) - uv * dot(w, v)) / whole, (uv * dot(w, u) - uu * dot(w, v)) / whole
        if 0 <= i <= 1 and 0 <= j <= 1:
            way = minus(at(r, j), at(s, i))
            distances.append(dot(way, way))
    return min(distances)


def squared_displacement_to_touch(ends, corners):
    """Returns the least squared distance: of an end from the triangle, if its foot is inside, and of the segment from
    an edge."""
    distances = [squared_distance_of_segments(ends, edge) for edge in combinations(corners, 2)]
    normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
    for p in ends if any(normal) else ():
        height = dot(normal, minus(p, corners[0])) / dot(normal, normal)
        foot = tuple(x - height * n for x, n in zip(p, normal))
        if common_interval((foot, foot), corners) is not None:
            distances.append(height**2 * dot(normal, normal))
    return min(distances)


def truth_segment_triangle(q):
    ends, corners = [[point(p) for p in q[name]] for name in ("segment", "triangle")]
    interval, margin = common_interval(ends, corners), squared_displacement_to_touch(ends, corners)
    if interval is None:
        return {"relation": "none"}, margin
    first, last = (at(ends, t) for t in interval)
    if first != last:
        return {"relation": "segment", "overlap": [written(first), written(last)]}, margin
    return {"relation": "point", "t": str(interval[0]), "point": written(first)}, margin


def truth_triangle_triangle(q):
    a, b = [[point(p) for p in q[name]] for name in "ab"]
    pairs = [(edge, other) for corners, other in ((a, b), (b, a)) for edge in combinations(corners, 2)]
    ends = {at(edge, t) for edge, other in pairs for t in common_interval(edge, other) or ()}
    margin = min(squared_displacement_to_touch(edge, other) for edge, other in pairs)
    if not ends:
        return {"relation": "none"}, margin
    # A point may become a segment where a triangle without area gets one, and an area a segment.
    first, *others = ends
    ways = [minus(p, first) for p in others]
    if not ways:
        return {"relation": "point"}, Fraction(0)
    if any(any(cross(ways[0], way)) for way in ways):
        return {"relation": "area"}, Fraction(0)
    return {"relation": "segment"}, margin
