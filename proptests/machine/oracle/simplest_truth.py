#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A second truth: slower, shorter, in Python's fractions. What two shapes have in common is found by cutting the interval of
the first one's parameter with half-planes; margins follow from their definition.

usage: simplest_truth.py CLAIMS OPERATIONS
CLAIMS: one {"op", "input", "truth", "margin"} a line; every difference is printed. OPERATIONS: one {"name", "words"} a line, what the
catalogue has; each must have its second truth here, and each of its words must have been seen, or the reason stands in WITHOUT.
"""
import json
import sys
from fractions import Fraction
from math import isqrt

ENDLESS = None
if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)


def number(value):
    return Fraction(float.fromhex(value)) if isinstance(value, str) else Fraction(value)


def point(value):
    return number(value[0]), number(value[1])


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def at(start, t, direction):
    return start[0] + t * direction[0], start[1] + t * direction[1]


def written(p):
    return [str(p[0]), str(p[1])]


def cut(interval, slope, height):
    """The part of (low, high) where slope t + height >= 0."""
    if interval is None or (slope == 0 and height < 0):
        return None
    low, high = interval
    if slope > 0:
        low = max(low, -height / slope)
    elif slope < 0:
        high = -height / slope if high is ENDLESS else min(high, -height / slope)
    return interval if slope == 0 else None if high is not ENDLESS and low > high else (low, high)


def cut_to_zero(interval, slope, height):
    return cut(cut(interval, slope, height), -slope, -height)


def in_common(start, direction, last, ends):
    """The interval of t in [0, last] where start + t direction is on the segment."""
    v, w = minus(ends[1], ends[0]), minus(start, ends[0])
    everything = (Fraction(0), last)
    if v == (0, 0):
        return cut_to_zero(cut_to_zero(everything, direction[0], w[0]), direction[1], w[1])
    on_line = cut_to_zero(everything, cross(v, direction), cross(v, w))
    return cut(cut(on_line, dot(v, direction), dot(v, w)), -dot(v, direction), dot(v, v) - dot(v, w))


def parameter(p, start, direction):
    axis = 0 if direction[0] != 0 else 1
    return Fraction(0) if direction == (0, 0) else (p[axis] - start[axis]) / direction[axis]


def squared_distance(p, start, direction, last):
    length = dot(direction, direction)
    t = Fraction(0) if length == 0 else max(Fraction(0), dot(minus(p, start), direction) / length)
    nearest = at(start, t if last is ENDLESS else min(t, last), direction)
    return dot(minus(p, nearest), minus(p, nearest))


def by_sign(value, below, zero, above):
    return below if value < 0 else above if value > 0 else zero


def explicit_line(q):
    p = point(q["point"])
    height = p[1] - number(q["slope"]) * p[0] - number(q["intercept"])
    return {"side": by_sign(height, "below", "on", "above")}, abs(height)


def point_ground_plane(q):
    height = number(q["point"][1])
    return {"side": by_sign(height, "below", "on", "above")}, abs(height)


class Root:
    """A square root with a sign. Equal to it is what is exactly it; where no rational is, what is within 2^-60 units in the last place."""

    def __init__(self, square, sign):
        self.square, self.sign = square, sign

    def __repr__(self):
        return f"{self.sign} sqrt({self.square})"

    def __eq__(self, said):
        value, square = self.sign * Fraction(said), self.square
        if all(isqrt(part) ** 2 == part for part in (square.numerator, square.denominator)):
            return value * value == square and value >= 0
        room = max(value / 2**112, Fraction(1, 2**1134))
        return value > 0 and max(Fraction(0), value - room) ** 2 < square < (value + room) ** 2


def point_plane(q):
    normal, p = [number(n) for n in q["plane"]["normal"]], [number(n) for n in q["point"]]
    height = sum(n * x for n, x in zip(normal, p)) + number(q["plane"]["offset"])
    square = height * height / sum(n * n for n in normal)
    return {"side": by_sign(height, "back", "on", "front"),
            "signed_distance": Root(square, by_sign(height, -1, 0, 1))}, square


def point_plane_toi(q):
    """Where the height over the plane, linear in t, is not positive: the interval [0, 1] cut."""
    normal = [number(n) for n in q["plane"]["normal"]]
    start, end = ([number(n) for n in q[name]] for name in ("start", "end"))
    first, last = (sum(n * x for n, x in zip(normal, p)) + number(q["plane"]["offset"]) for p in (start, end))
    behind = cut((Fraction(0), Fraction(1)), first - last, -first)
    truth = {"option_1": {"relation": "hit" if last <= 0 else "never"}, "option_2": {"relation": "never"}}
    if behind is not None:
        t = behind[0]
        truth["option_2"] = {"relation": "hit", "t": str(t), "point": [str(a + t * (b - a)) for a, b in zip(start, end)]}
    return truth, None


def implicit_circle(q):
    (x, y), (a, b), r = point(q["point"]), point(q["circle"]["center"]), number(q["circle"]["radius"])
    power = x * x + y * y - 2 * a * x - 2 * b * y + a * a + b * b - r * r
    return {"location": by_sign(power, "inside", "boundary", "outside")}, abs(power)


def line_point_at(q):
    return {"point": written(at(point(q["line"]["origin"]), number(q["t"]), point(q["line"]["direction"])))}, None


def orientation(q):
    (a, b), (c, d), (e, f) = point(q["p0"]), point(q["p1"]), point(q["p"])
    area = a * d + c * f + e * b - b * c - d * e - f * a
    return {"side": by_sign(area, "right", "on", "left")}, abs(area)


def point_on_segment(q):
    p, ends = point(q["point"]), [point(end) for end in q["segment"]]
    v = minus(ends[1], ends[0])
    margin = squared_distance(p, ends[0], v, Fraction(1))
    on = in_common(p, (Fraction(0), Fraction(0)), Fraction(0), ends)
    return {"relation": "on", "t": str(parameter(p, ends[0], v))} if on else {"relation": "off"}, margin


def line_line(q):
    (a, a_end), (b, b_end) = [[point(end) for end in q[name]] for name in "ab"]
    u, v = minus(a_end, a), minus(b_end, b)
    slope, height = cross(v, u), cross(v, minus(a, b))  # how far a + t u is from b's line
    if slope == 0:
        return {"relation": "same" if height == 0 else "parallel"}, Fraction(0)
    p = at(a, -height / slope, u)
    numbers = {"ta": str(-height / slope), "tb": str(parameter(p, b, v)), "point": written(p)}
    return {"relation": "crossing", **numbers}, abs(slope)


def segment_segment(q):
    a, b = [[point(end) for end in q[name]] for name in "ab"]
    u, v, one = minus(a[1], a[0]), minus(b[1], b[0]), Fraction(1)
    margin = min([squared_distance(p, b[0], v, one) for p in a] + [squared_distance(p, a[0], u, one) for p in b])
    interval = in_common(a[0], u, one, b)
    if interval is None:
        return {"relation": "disjoint"}, margin
    first, last = at(a[0], interval[0], u), at(a[0], interval[1], u)
    if first != last:
        return {"relation": "overlap", "overlap": [written(p) for p in sorted((first, last))]}, margin
    numbers = {"ta": str(parameter(first, a[0], u)), "tb": str(parameter(first, b[0], v)), "point": written(first)}
    return {"relation": "point", **numbers}, margin


def ray_segment(q):
    start, direction = point(q["ray"]["origin"]), point(q["ray"]["direction"])
    ends = [point(end) for end in q["segment"]]
    margin = min([squared_distance(p, start, direction, ENDLESS) for p in ends]
                 + [squared_distance(start, ends[0], minus(ends[1], ends[0]), Fraction(1))])
    interval = in_common(start, direction, ENDLESS, ends)
    if interval is None:
        return {"relation": "none"}, margin
    first, last = at(start, interval[0], direction), at(start, interval[1], direction)
    if first != last:
        return {"relation": "overlap", "t": str(interval[0]), "overlap": [written(first), written(last)]}, margin
    return {"relation": "point", "t": str(interval[0]), "point": written(first)}, margin


def turn(ring, i):
    """To which side the ring turns at vertex i: > 0 is left."""
    a, b, c = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
    return cross(minus(b, a), minus(c, b))


def crosses_itself(ring):
    """Whether two edges, which are no points, have in common what is not the one vertex that neighbours share."""
    edges = [(p, ring[(i + 1) % len(ring)]) for i, p in enumerate(ring)]
    for j, (c, d) in enumerate(edges):
        for i, (a, b) in enumerate(edges[:j]):
            shared = [p for p, joined in ((c, j == i + 1), (a, (j + 1) % len(ring) == i)) if joined]
            interval = in_common(a, minus(b, a), Fraction(1), (c, d))
            if interval and not all(at(a, t, minus(b, a)) in shared for t in interval):
                return True
    return False


def polygon_convexity(q):
    ring = [point(p) for p in q["polygon"]]
    turns = [turn(ring, i) for i in range(len(ring))]
    flat = all(cross(minus(p, ring[0]), minus(r, ring[0])) == 0 for p in ring for r in ring)
    degenerate = flat or any(p == ring[i - 1] for i, p in enumerate(ring))
    if degenerate or crosses_itself(ring):
        return {"class": "degenerate" if degenerate else "not_simple", "strict": False, "orientation": "none"}, None
    convex = min(turns) >= 0 or max(turns) <= 0
    lowest = turns[min(range(len(ring)), key=lambda i: ring[i])]  # the ring turns there as it turns as a whole
    return {"class": "convex" if convex else "concave", "strict": convex and 0 not in turns,
            "orientation": "ccw" if lowest > 0 else "cw"}, None


def doubled_area(ring):
    return sum((cross(p, q) for p, q in zip(ring, ring[1:] + ring[:1])), Fraction(0))


def side(p, q, r):
    return cross(minus(q, p), minus(r, p))


def triangles(ring):
    """Ears cut off one by one; flat vertices are left out."""
    ring = ring if doubled_area(ring) > 0 else ring[::-1]
    while len(ring) > 2:
        for i, q in enumerate(ring):
            p, r = ring[i - 1], ring[(i + 1) % len(ring)]
            others = [v for v in ring if v not in (p, q, r)]
            inside = any(side(p, q, v) >= 0 and side(q, r, v) >= 0 and side(r, p, v) >= 0 for v in others)
            if side(p, q, r) == 0 or (side(p, q, r) > 0 and not inside):
                if side(p, q, r) > 0:
                    yield [p, q, r]
                ring = ring[:i] + ring[i + 1 :]
                break


def clipped(ring, p, q):
    """The part of a convex ring to the left of p -> q."""
    kept = []
    for v, w in zip(ring, ring[1:] + ring[:1]):
        before, after = side(p, q, v), side(p, q, w)
        if before >= 0:
            kept.append(v)
        if before * after < 0:
            kept.append(at(v, before / (before - after), minus(w, v)))
    return kept


def overlap(s, t):
    for i in range(3):
        s = clipped(s, t[i], t[(i + 1) % 3])
    return len(s) > 2 and doubled_area(s) > 0


def polygon_polygon(given):
    """The triangles of one clipped to those of the other; without a common area only a vertex on an edge can be a contact."""
    a, b = ([point(p) for p in given[name]] for name in "ab")
    margin = min(
        squared_distance(v, p, minus(q, p), Fraction(1)) for one, other in ((a, b), (b, a)) for v in one for p, q in zip(other, other[1:] + other[:1])
    )
    if any(overlap(s, t) for s in triangles(a) for t in triangles(b)):
        return {"contact": "overlapping"}, margin
    return {"contact": "touching" if margin == 0 else "disjoint"}, margin


def point_in_polygon(q):
    """By a ray upwards: it passes the edges that have one end strictly to the right of it."""
    ring, p = [minus(point(vertex), point(q["point"])) for vertex in q["polygon"]], (Fraction(0), Fraction(0))
    edges = list(zip(ring, ring[1:] + ring[:1]))
    margin = min(squared_distance(p, a, minus(b, a), Fraction(1)) for a, b in edges)
    inside = sum((a[0] > 0) != (b[0] > 0) and (cross(a, b) > 0) == (a[0] > 0) for a, b in edges) % 2 == 1
    return {"location": "boundary" if margin == 0 else "inside" if inside else "outside"}, margin


def point_in_convex_polygon(q):
    return point_in_polygon(q)


TRUTHS = {truth.__name__: truth for truth in (explicit_line, implicit_circle, line_point_at, orientation, point_on_segment,
                                              line_line, segment_segment, ray_segment, polygon_convexity, point_in_polygon,
                                              point_in_convex_polygon, polygon_polygon, point_ground_plane, point_plane,
                                              point_plane_toi)}
# Operations that have no second truth here, and why.
WITHOUT = {
    "polygon_normal": "its unit vector is irrational; the checkers of certificates compare its squares",
    "parametric_circle": "its answer is irrational; proptests/machine/oracle/circular.cpp compares it with MPFR",
    "interior_angles": "its answers are irrational; the checkers of certificates enclose them by series of their own",
    "triangulate_polygon": "many answers are right; certify_triangulation.py proves each in fractions",
    "convex_partition": "many answers are right; certify_triangulation.py proves each in fractions",
}


def words_in(truth):
    """Every word of an answer, at any depth."""
    if isinstance(truth, dict):
        return set().union(*map(words_in, truth.values()))
    return {truth} if isinstance(truth, str) and truth.strip("-0123456789/") else set()


def unseen(operations, seen):
    """What is missing of the catalogue: operations without a truth here, words that no claim had."""
    for operation in operations:
        name = operation["name"]
        if name in WITHOUT:
            continue
        if name not in TRUTHS:
            yield f"{name}: no second truth, and no reason why (TRUTHS, WITHOUT)"
        for word in operation["words"] or [""]:
            if (name, word) not in seen:
                yield f"{name}: no claim with the answer {word!r} was compared"


def main(path, listed):
    seen, wrong = set(), 0
    with open(path, encoding="utf-8") as lines:
        for position, text in enumerate(lines, 1):
            claim = json.loads(text)
            if claim["op"] not in TRUTHS:
                continue
            truth, margin = TRUTHS[claim["op"]](claim["input"])
            seen |= {(claim["op"], word) for word in words_in(truth) or {""}}
            if truth != claim["truth"] or (margin is not None and str(margin) != claim["margin"]):
                wrong += 1
                print(f"{path}:{position}: {truth}, margin {margin}, instead of {text[:600]}")
    with open(listed, encoding="utf-8") as lines:
        missing = list(unseen([json.loads(line) for line in lines], seen))
    print(*missing, sep="\n")
    return 1 if wrong or missing else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
