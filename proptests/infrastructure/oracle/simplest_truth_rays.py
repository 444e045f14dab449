# SPDX-License-Identifier: Apache-2.0
"""The second truths of rays and segments, for simplest_truth.py: the interval of t in which the point start + t way is
in the other shape, cut by one inequality after the other.

A line is (start, way, last): the last t is 1, or a ray has none."""
from fractions import Fraction

from simplest_truth_mixed import place_in
from simplest_truth_polyhedra import cross
from simplest_truth_reading import ENDLESS, cut, cut_to_zero, dot, minus, named_triangles, number, point


def line_of(q):
    if "ray" in q:
        return point(q["ray"]["origin"]), point(q["ray"]["direction"]), ENDLESS
    a, b = map(point, q["segment"])
    return a, minus(b, a), Fraction(1)


def written(start, t, way):
    return [str(x + t * v) for x, v in zip(start, way)]


def of_plane(q):
    """Margin: the squared distance from the plane that is least, of the two points that the question gives, and of a
    ray's direction as a point from the parallel plane through 0."""
    start, way, last = line_of(q)
    normal = point(q["plane"]["normal"])
    height, climb = dot(normal, start) + number(q["plane"]["offset"]), dot(normal, way)
    margin = min(height**2, (climb if last is ENDLESS else height + climb) ** 2) / dot(normal, normal)
    interval = cut_to_zero((Fraction(0), last), climb, height)
    if interval is None:
        return {"relation": "none"}, margin
    if interval[0] != interval[1]:
        return {"relation": "inside"}, margin
    return {"relation": "point", "t": str(interval[0]), "point": written(start, interval[0], way)}, margin


truth_ray_plane = truth_segment_plane = of_plane


def squared_distance(line, p):
    start, way, last = line
    foot = max(Fraction(0), dot(minus(p, start), way) / dot(way, way)) if any(way) else Fraction(0)
    nearest = tuple(x + (foot if last is ENDLESS else min(foot, last)) * v for x, v in zip(start, way))
    return dot(minus(p, nearest), minus(p, nearest))


def squared_distance_of_lines(one, other):
    """The other is a segment. From an end of either, or between two points of which the connection is at right angles
    to both."""
    (start, u, last), (beginning, v, _) = one, other
    w, normal = minus(beginning, start), cross(u, v)
    end = tuple(x + y for x, y in zip(beginning, v))
    distances = [squared_distance(one, beginning), squared_distance(one, end), squared_distance(other, start)]
    if any(normal):
        square = dot(normal, normal)
        on_one, on_other = dot(cross(w, v), normal) / square, dot(cross(w, u), normal) / square
        if 0 <= on_one and (last is ENDLESS or on_one <= last) and 0 <= on_other <= 1:
            distances.append(dot(w, normal) ** 2 / square)
    return min(distances)


def in_triangle(ray, corners):
    """The interval in common, whether its first point is inside, the margin.

    In the plane of the triangle, and on the inner side of each edge; without area, on the line of two corners, and
    between the extreme ones on each axis. Margin: of the origin from the triangle where its foot is inside, and of the
    ray from each edge."""
    start, way, last = ray
    normal = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]))
    edges = [(a, minus(b, a), Fraction(1)) for a, b in zip(corners, corners[1:] + corners[:1])]

    def cut_by(interval, rows, cutter):
        for n, at in rows:
            interval = cutter(interval, dot(n, way), dot(n, minus(start, at)))
        return interval

    everything, axes = (Fraction(0), last), ((1, 0, 0), (0, 1, 0), (0, 0, 1))
    inwards = [(cross(normal, v), a) for a, v, _ in edges]
    margin = min(squared_distance_of_lines(ray, edge) for edge in edges)
    if any(normal):
        interval = cut_by(cut_by(everything, [(normal, corners[0])], cut_to_zero), inwards, cut)
        if all(dot(n, minus(start, a)) >= 0 for n, a in inwards):
            margin = min(margin, dot(normal, minus(start, corners[0])) ** 2 / dot(normal, normal))
    else:
        along = max((v for _, v, _ in edges), key=lambda v: dot(v, v))
        on_line = [(cross(along, axis), corners[0]) for axis in axes]
        low = [tuple(min(p[k] for p in corners) for k in range(3))] * 3
        high = [tuple(max(p[k] for p in corners) for k in range(3))] * 3
        interval = cut_by(cut_by(everything, on_line, cut_to_zero), list(zip(axes, low)), cut)
        interval = cut_by(interval, [(tuple(-x for x in axis), at) for axis, at in zip(axes, high)], cut)
    if interval is None:
        return None, False, margin
    x = tuple(a + interval[0] * v for a, v in zip(start, way))
    return interval, any(normal) and all(dot(n, minus(x, a)) > 0 for n, a in inwards), margin


def truth_ray_triangle(q):
    start, way, last = line_of(q)
    interval, inside, margin = in_triangle((start, way, last), [point(p) for p in q["triangle"]])
    if interval is None:
        return {"relation": "none"}, margin
    first = {"t": str(interval[0]), "point": written(start, interval[0], way)}
    if interval[0] != interval[1]:
        return {"relation": "segment"} | first, margin
    return {"relation": "point", **first, "location": "inside" if inside else "boundary"}, margin


def truth_ray_mesh(q):
    """Triangle by triangle. Margin: that of each, and the squared distances of the first point from the first of other
    faces."""
    (start, way, last), vertices = line_of(q), [point(p) for p in q["mesh"]["vertices"]]
    met, margins = [], []
    for face, corners in named_triangles(q["mesh"]):
        interval, _, margin = in_triangle((start, way, last), [vertices[k] for k in corners])
        margins.append(margin)
        if interval is not None:
            met.append((interval[0], face))
    if not met:
        return {"relation": "none", "faces_met": 0}, min(margins, default=None)
    t, face = min(met)
    margins += [(other - t) ** 2 * dot(way, way) for other, i in met if i != face]
    x = tuple(p + t * v for p, v in zip(start, way))
    part = place_in([vertices[k] for k in q["mesh"]["faces"][face]], x)
    first = {"t": str(t), "point": written(start, t, way), "face": face, "part": part}
    return {"relation": "hit", "first": first, "faces_met": len({face for _, face in met})}, min(margins)


def of_box(q):
    """Margin: of two inequalities of different axes, or of one, the higher one at its lowest; the greatest of these."""
    (start, way, last), low, high = line_of(q), point(q["aabb"]["min"]), point(q["aabb"]["max"])
    interval, rows = (Fraction(0), last), []
    for axis, (x, v, least, most) in enumerate(zip(start, way, low, high)):
        interval = cut(cut(interval, v, x - least), -v, most - x)
        rows += [(least - x, -v, axis), (x - most, v, axis)]

    def lowest(one, other):
        crossing = (one[0] - other[0]) / (other[1] - one[1]) if one[1] != other[1] else Fraction(0)
        tried = [Fraction(0), max(crossing, Fraction(0))]
        if last is not ENDLESS:
            tried = [min(t, last) for t in tried] + [last]
        elif one[1] < 0 and other[1] < 0:
            return None
        return min(max(height + slope * t for height, slope, _ in (one, other)) for t in tried)

    found = [lowest(one, other) for one in rows for other in rows if one[2] != other[2] or one == other]
    margin = abs(max(value for value in found if value is not None))
    if interval is None:
        return {"relation": "none"}, margin
    first, last = interval if any(way) else (Fraction(0), Fraction(0))
    return {"relation": "hit", "first": str(first), "last": str(last)}, margin


class Zero:
    """The smaller (side -1) or the greater (side 1) zero of C + B t + A t^2. Equal to it is its text: a rational zero
    on that side of the vertex, or the vertex and a root with that sign, of which the square is compared."""

    def __init__(self, constant, linear, square, side):
        self.constant, self.linear, self.square, self.side = constant, linear, square, side

    def __repr__(self):
        return f"zero {self.side} of {self.constant} + {self.linear} t + {self.square} t^2"

    def __eq__(self, said):
        vertex = -self.linear / (2 * self.square)
        lead, _, radicand = said.partition("sqrt(")
        if not radicand:
            t = Fraction(said)
            return self.side * (t - vertex) >= 0 and self.constant + self.linear * t + self.square * t * t == 0
        lead = lead.removesuffix("*")
        cut_at = max(lead.rfind("+"), lead.rfind("-"), 0)
        part, size = lead[:cut_at], lead[cut_at:].lstrip("+-")
        beyond = Fraction(size or 1) ** 2 * Fraction(radicand.removesuffix(")"))
        sign = -1 if lead[cut_at : cut_at + 1] == "-" else 1
        square = vertex**2 - self.constant / self.square
        return Fraction(part or 0) == vertex and sign == self.side and beyond == square


def of_ball(q):
    """The gap, the squared distance from the center over the squared radius, falls to its vertex, and is looked at
    there or at the end of the line that is nearer to it; margin: its size there."""
    (start, way, last), center, radius = line_of(q), point(q["sphere"]["center"]), number(q["sphere"]["radius"])
    p = minus(start, center)
    constant, linear, square = dot(p, p) - radius**2, 2 * dot(p, way), dot(way, way)

    def gap(t):
        return constant + linear * t + square * t * t

    nearest = max(-linear / (2 * square), Fraction(0)) if square else Fraction(0)
    nearest = nearest if last is ENDLESS else min(nearest, last)
    if gap(nearest) > 0:
        return {"relation": "none"}, gap(nearest)
    if not square:
        return {"relation": "hit", "first": "0", "last": "0"}, -gap(nearest)
    first = "0" if constant <= 0 else Zero(constant, linear, square, -1)
    greater = Zero(constant, linear, square, 1)
    return {"relation": "hit", "first": first, "last": "1" if last and gap(last) <= 0 else greater}, -gap(nearest)


def of_capsule(q):
    """Between two times at which the line is level with an end of the axis, the gap, the squared distance from the axis
    over the squared radius, is that from an end, or from the axis's line: it is looked at where it is nearest there.
    Beyond `far` a ray only gets farther away. Margin: the size of the least gap."""
    (start, way, last), (a, b), radius = line_of(q), map(point, q["capsule"]["segment"]), number(q["capsule"]["radius"])
    axis, p = minus(b, a), minus(start, a)
    length, place, climb, speed = dot(axis, axis), dot(p, axis), dot(way, axis), dot(way, way)
    far = 1 + 3 * (4 * dot(p, p) + length + radius**2) / speed if last is ENDLESS else last
    level = [(end - place) / climb for end in (0, length)] if climb else []
    times = sorted({Fraction(0), far} | {t for t in level if 0 < t < far})
    pieces = []
    for before, after in zip(times, times[1:]):
        height = place + (before + after) / 2 * climb
        end = minus(start, b if height > length else a)
        f = dot(end, end) - radius**2, 2 * dot(end, way), speed
        if length and 0 <= height <= length:
            f = f[0] - place**2 / length, f[1] - 2 * place * climb / length, speed - climb**2 / length
        nearest = min(max(-f[1] / (2 * f[2]), before), after) if f[2] else before
        gaps = [f[0] + f[1] * t + f[2] * t * t for t in (before, nearest, after)]
        pieces.append((f, gaps))
    least = min(gaps[1] for _, gaps in pieces)
    if least > 0:
        return {"relation": "none"}, least
    if not speed:
        return {"relation": "hit", "first": "0", "last": "0"}, -least
    met = [f for f, gaps in pieces if gaps[1] <= 0]
    first = "0" if pieces[0][1][0] <= 0 else Zero(*met[0], -1)
    return {"relation": "hit", "first": first, "last": "1" if pieces[-1][1][2] <= 0 else Zero(*met[-1], 1)}, -least


def of_obb(q):
    """Between the planes of opposite faces, pair by pair. Margin: the planes that two half axes span, or one and the way,
    at their distance in the maximum norm from the line that is moved until it lies on them: the greatest."""
    (start, way, last), axes = line_of(q), [point(axis) for axis in q["obb"]["half_axes"]]
    start = minus(start, point(q["obb"]["center"]))

    def reach(normal):
        return sum(abs(dot(normal, axis)) for axis in axes)

    interval, u, v, w = (Fraction(0), last), *axes
    faces = [cross(u, v), cross(v, w), cross(w, u)]
    normals = [n for n in faces + [cross(axis, way) for axis in axes] if any(n)]
    normals += [tuple(-x for x in n) for n in normals]
    for n in faces:
        for side in (1, -1):
            interval = cut(interval, side * dot(n, way), reach(n) + side * dot(n, start))
    gaps = []
    for n in normals:
        rate = dot(n, way)
        if rate >= 0 or last is not ENDLESS:
            gaps.append((dot(n, start) + min(rate, 0) - reach(n)) / sum(map(abs, n)))
    if interval is None:
        return {"relation": "none"}, abs(max(gaps))
    first, last = interval if any(way) else (Fraction(0), Fraction(0))
    return {"relation": "hit", "first": str(first), "last": str(last)}, abs(max(gaps))


truth_ray_aabb = truth_segment_aabb = of_box
truth_ray_capsule = truth_segment_capsule = of_capsule
truth_ray_obb = truth_segment_obb = of_obb
truth_ray_sphere = truth_segment_sphere = of_ball
