# SPDX-License-Identifier: Apache-2.0
"""The second truth of moving shapes, in the style of simplest_truth.py."""
from fractions import Fraction
from itertools import combinations
from math import lcm

from simplest_truth_mixed import clamped, foot_on_face
from simplest_truth_polyhedra import cross
from simplest_truth_reading import dot, minus, named_triangles, number, point, triangles


class FirstRoot:
    """The least zero of a polynomial C + B t + A t^2 that is positive at 0. Equal to it is its text: a rational zero
    that is not beyond the vertex, or the vertex less a root, of which the square is compared."""

    def __init__(self, constant, linear, square):
        self.constant, self.linear, self.square = constant, linear, square

    def __repr__(self):
        return f"least t with {self.constant} + {self.linear} t + {self.square} t^2 = 0"

    def __eq__(self, said):
        vertex = -self.linear / (2 * self.square)
        lead, _, radicand = said.partition("sqrt(")
        if not radicand:
            t = Fraction(said)
            return t <= vertex and self.constant + self.linear * t + self.square * t * t == 0
        lead = lead.removesuffix("*")
        cut = max(lead.rfind("+"), lead.rfind("-"))
        part, size = Fraction(lead[: max(cut, 0)] or 0), Fraction(lead[cut + 1 :] or 1)
        beyond = size * size * Fraction(radicand.removesuffix(")")) - (vertex**2 - self.constant / self.square)
        return part == vertex and lead[cut : cut + 1] == "-" and beyond == 0


def truth_swept_sphere_sphere(q):
    """The gap, the squared distance of the centers over that of touching balls, falls to its vertex: it is looked at
    there, or at the end of the step that is nearer to it."""
    p = minus(point(q["a"]["center"]), point(q["b"]["center"]))
    w = minus(point(q["velocity_a"]), point(q["velocity_b"]))
    reach = number(q["a"]["radius"]) + number(q["b"]["radius"])

    def gap(t):
        return sum((x + t * y) ** 2 for x, y in zip(p, w)) - reach * reach

    square = dot(w, w)
    constant, linear = gap(0), gap(1) - gap(0) - square
    nearest = min(max(-linear / (2 * square), Fraction(0)), Fraction(1)) if square else Fraction(0)
    if constant <= 0:
        return {"relation": "hit", "t": "0"}, abs(gap(nearest))
    if gap(nearest) > 0:
        return {"relation": "never"}, gap(nearest)
    return {"relation": "hit", "t": FirstRoot(constant, linear, square)}, -gap(nearest)


def truth_swept_aabb_aabb(q):
    """On each axis two lines over t, height + slope t, must not be above 0. They all meet that first at 0 or where one
    of them is 0, if ever. Margin: where two lines of different axes take turns at being the higher one, or at an end of
    the step, the higher one is at its lowest; the greatest of these values."""
    lines = []
    for axis, (a, c, b, d, v) in enumerate(
        zip(q["a"]["min"], q["a"]["max"], q["b"]["min"], q["b"]["max"], q["velocity"])
    ):
        lines += [(number(b) - number(c), -number(v), axis), (number(a) - number(d), number(v), axis)]
    times = {Fraction(0)} | {-height / slope for height, slope, _ in lines if slope and 0 <= -height / slope <= 1}
    met = [t for t in times if all(height + slope * t <= 0 for height, slope, _ in lines)]

    def lowest(one, other):
        crossing = (one[0] - other[0]) / (other[1] - one[1]) if one[1] != other[1] else 0
        tried = {Fraction(0), Fraction(1), min(max(crossing, Fraction(0)), Fraction(1))}
        return min(max(height + slope * t for height, slope, _ in (one, other)) for t in tried)

    margin = abs(max(lowest(one, other) for one in lines for other in lines if one[2] != other[2] or one == other))
    return ({"relation": "hit", "t": str(min(met))} if met else {"relation": "never"}), margin


def first_at_plane(ends, radius, q):
    """The interval of heights that balls around the ends reach, times the length of the normal, has its ends at roots:
    they are compared by squares with signs. Margin: how far the squares of the radius and of the nearer way out are
    apart."""
    normal, radius = point(q["plane"]["normal"]), number(radius)
    starts = [dot(normal, point(end)) + number(q["plane"]["offset"]) for end in ends]
    rise, square = dot(normal, point(q["velocity"])), dot(normal, normal)
    heights = starts + [start + rise for start in starts]

    def signed(height):
        return height * abs(height) / square

    margin = min(radius**2 + signed(max(heights)), radius**2 - signed(min(heights)))
    nearer = min(starts, key=abs)
    if nearer**2 <= radius**2 * square or min(starts) < 0 < max(starts):
        return {"relation": "hit", "t": "0"}, abs(margin)
    if margin < 0:
        return {"relation": "never"}, abs(margin)
    return {"relation": "hit", "t": FirstRoot(nearer**2 - radius**2 * square, 2 * nearer * rise, rise**2)}, abs(margin)


def truth_swept_sphere_plane(q):
    return first_at_plane([q["sphere"]["center"]], q["sphere"]["radius"], q)


def truth_swept_capsule_plane(q):
    return first_at_plane(q["capsule"]["segment"], q["capsule"]["radius"], q)


def first_in_pieces(gap, passed):
    """The first zero and the least value of a function that is a polynomial of degree 2 between these times. Three
    values give each; it is looked at where it is least in each piece."""
    times = sorted({Fraction(0), Fraction(1)} | {t for t in passed if 0 < t < 1})
    first, margin = "0" if gap(times[0]) <= 0 else None, gap(times[0])
    for start, end in zip(times, times[1:]):
        middle, half = (start + end) / 2, (end - start) / 2
        rise, bend = (gap(end) - gap(start)) / (2 * half), (gap(end) + gap(start) - 2 * gap(middle)) / (2 * half**2)
        nearest = min(max(middle - rise / (2 * bend), start), end) if bend else start
        least = min(gap(start), gap(nearest), gap(end))
        if first is None and least <= 0:
            constant, linear = gap(middle) - rise * middle + bend * middle**2, rise - 2 * bend * middle
            first = FirstRoot(constant, linear, bend)
        margin = min(margin, least)
    return {"relation": "never"} if first is None else {"relation": "hit", "t": first}, margin


def truth_swept_sphere_aabb(q):
    """The gap, the squared distance of the center from the box less r^2, is a polynomial between the times at which the
    center passes the plane of a face. Margin: the least gap, and where the center is in the box, how far it is from
    missing it."""
    radius = number(q["sphere"]["radius"])
    low, high = point(q["aabb"]["min"]), point(q["aabb"]["max"])
    axes = list(zip(point(q["sphere"]["center"]), point(q["velocity"]), low, high))

    def gap(t):
        return sum(max(least - c - t * v, 0, c + t * v - most) ** 2 for c, v, least, most in axes) - radius**2

    first, margin = first_in_pieces(gap, {(side - c) / v for c, v, *sides in axes if v for side in sides})
    if margin == -(radius**2):
        center = {"min": q["sphere"]["center"], "max": q["sphere"]["center"]}
        margin -= truth_swept_aabb_aabb({"a": center, "b": q["aabb"], "velocity": q["velocity"]})[1] ** 2
    return first, abs(margin)


def first_at_polygon(center, radius, v, corners):
    """The same of a polygon; the gap changes on planes at right angles to an edge through its ends, and to the face
    through it. Margin: where the center is in the polygon, also how far it is from missing it, along the face or past
    an edge."""
    following = list(zip(corners, corners[1:] + corners[:1]))
    edges = [minus(q, p) for p, q in following]
    face = cross(*edges[:2])

    def gap(t):
        p = tuple(c + t * x for c, x in zip(center, v))
        near = [clamped(p, *ends) for ends in following]
        near += [x for k in range(2, len(corners)) for x in foot_on_face(p, corners[0], corners[k - 1], corners[k])]
        return min(dot(minus(p, x), minus(p, x)) for x in near) - radius**2

    planes = [(n, p) for e, ends in zip(edges, following) for p in ends for n in (e, cross(face, e))]
    first, margin = first_in_pieces(gap, {dot(n, minus(p, center)) / dot(n, v) for n, p in planes if dot(n, v)})
    if margin == -(radius**2):
        depths = []
        for n in [face] + [cross(e, v) for e in edges]:
            heights = [dot(n, minus(center, p)) + t * dot(n, v) for p in corners for t in (0, 1)]
            depths += [min(abs(min(heights)), abs(max(heights))) ** 2 / dot(n, n)] if any(n) else []
        margin -= min(depths, default=0)
    return first, abs(margin)


def truth_swept_sphere_triangle(q):
    center, radius = point(q["sphere"]["center"]), number(q["sphere"]["radius"])
    return first_at_polygon(center, radius, point(q["velocity"]), list(map(point, q["triangle"])))


def vertex_and_square(t):
    """A time is v - sqrt(d): v and d."""
    if t == "0":
        return Fraction(0), Fraction(0)
    vertex = -t.linear / (2 * t.square)
    return vertex, vertex**2 - t.constant / t.square


def is_before(one, other):
    """v + sqrt(e) < w + sqrt(d), by squares."""
    (v, d), (w, e) = vertex_and_square(one), vertex_and_square(other)
    n = v - w
    rest, square = d - e - n * n, 4 * n * n * e
    if n < 0:
        return n * n > e or rest > 0 or square > rest * rest
    return rest > 0 and square < rest * rest


def truth_swept_sphere_mesh(q):
    """Triangle by triangle. Margin: that of each, or 0 if another face is met at once; at the start, of the triangles up to
    the first that is met at rest."""
    first, face, margins, at_once = None, None, [], False
    ball, vertices = {"sphere": q["sphere"], "velocity": q["velocity"]}, q["mesh"]["vertices"]
    faces = [face for face, _ in named_triangles(q["mesh"])]
    questions = [ball | {"triangle": [vertices[k] for k in corners]} for corners in triangles(q["mesh"])]
    for i, question in enumerate(questions):
        answer, margin = truth_swept_sphere_triangle(question)
        margins.append(margin)
        t = answer.get("t")
        if t is None or first is not None and is_before(first, t):
            continue
        tie = first is not None and not is_before(t, first)
        at_once = tie and (at_once or faces[i] != faces[face])
        if not tie:
            first, face = t, i
    if first is None:
        return {"relation": "never"}, min(margins, default=None)
    if first == "0":
        rest = [question | {"velocity": [0, 0, 0]} for question in questions[: face + 1]]
        margins = [truth_swept_sphere_triangle(question)[1] for question in rest]
    margin = 0 if at_once and first != "0" else min(margins)
    return {"relation": "hit", "t": first, "face": faces[face]}, margin


def truth_swept_capsule_capsule(q):
    """The points of b, less displacements along a, are seen from an end of a."""
    (p, end), (c, d) = (map(point, q[name]["segment"]) for name in ("a", "b"))
    corners = [c, d, minus(d, minus(end, p)), minus(c, minus(end, p))]
    radius = number(q["a"]["radius"]) + number(q["b"]["radius"])
    return first_at_polygon(p, radius, point(q["velocity"]), corners)


def truth_swept_convex_polyhedra(q):
    """b less a, swept backwards, and that with a cube around it, are polytopes: normals of their facets are normals of
    faces, or cross products of edges, of the velocity and of the axes. On each, a has to be between two numbers, from
    which an interval of t follows, and how far it is beyond one of them at best."""
    a, b = ([point(v) for v in q[name]["vertices"]] for name in ("a", "b"))
    velocity = point(q["velocity"])
    scale = lcm(*(x.denominator for p in a + b + [velocity] for x in p))
    a, b, velocity = ([tuple(int(x * scale) for x in p) for p in points] for points in (a, b, [velocity]))

    def edges(points, faces):
        return {minus(points[j], points[i]) for f in faces for i, j in (f[:2], f[1:], f[::2])}

    axes = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]
    parts = [edges(a, triangles(q["a"])), edges(b, triangles(q["b"])), velocity, axes]
    normals = {cross(u, v) for one, other in combinations(parts, 2) for u in one for v in other} | set(axes)
    for points, faces in ((a, triangles(q["a"])), (b, triangles(q["b"]))):
        normals |= {cross(minus(points[j], points[i]), minus(points[k], points[i])) for i, j, k in faces}
    first, last, beyond = Fraction(0), Fraction(1), []
    for n in normals - {(0, 0, 0)}:
        of_a, of_b, speed = [dot(n, p) for p in a], [dot(n, p) for p in b], dot(n, velocity[0])
        for low in (min(of_b) - max(of_a), min(of_a) - max(of_b)):  # low - speed t has to be at most 0
            beyond.append(Fraction(low - max(speed, 0), sum(map(abs, n))))
            if speed > 0:
                first = max(first, Fraction(low, speed))
            elif speed < 0:
                last = min(last, Fraction(low, speed))
            elif low > 0:
                last = Fraction(-1)
            speed = -speed
    hit = {"relation": "hit", "t": str(first)} if first <= last else {"relation": "never"}
    return hit, abs(max(beyond)) / scale


def truth_swept_obb_obb(q):
    """b less a is a sum of segments, and so is that swept backwards, the velocity being one more: it is between two
    planes for each pair of these, with the cross product as normal. Margin: how far the way between the centers is from
    the nearest of these planes, or beyond the farthest."""
    edges = [point(axis) for name in ("a", "b") for axis in q[name]["half_axes"]]
    way, velocity = minus(point(q["b"]["center"]), point(q["a"]["center"])), point(q["velocity"])
    first, last, beyond = Fraction(0), Fraction(1), []
    for n in (cross(u, v) for u, v in combinations([*edges, velocity], 2)):
        if not any(n):
            continue
        height, reach, speed = dot(n, way), sum(abs(dot(n, e)) for e in edges), dot(n, velocity)
        above = abs(height - speed / 2) - reach - abs(speed) / 2
        beyond.append(above * abs(above) / dot(n, n))
        if speed:
            times = [Fraction(height + side) / speed for side in (-reach, reach)]
            first, last = max(first, min(times)), min(last, max(times))
        elif abs(height) > reach:
            last = Fraction(-1)
    hit = {"relation": "hit", "t": str(first)} if first <= last else {"relation": "never"}
    return hit, abs(max(beyond))
