# SPDX-License-Identifier: Apache-2.0
"""The second truth of lines: the interval of the first shape's parameter, cut with half-planes."""
from fractions import Fraction

from simplest_truth_reading import (
    ENDLESS, at, by_sign, cross, in_common, minus, number, parameter, point, squared_distance, written,
)

# Operations of the chapter that have no second truth, and why.
WITHOUT = {
    "parametric_circle": "its answer is irrational; proptests/infrastructure/oracle/circular.cpp compares it with MPFR",
}


def truth_explicit_line(q):
    p = point(q["point"])
    height = p[1] - number(q["slope"]) * p[0] - number(q["intercept"])
    return {"side": by_sign(height, "below", "on", "above")}, abs(height)


def truth_implicit_circle(q):
    (x, y), (a, b), r = point(q["point"]), point(q["circle"]["center"]), number(q["circle"]["radius"])
    power = x * x + y * y - 2 * a * x - 2 * b * y + a * a + b * b - r * r
    return {"location": by_sign(power, "inside", "boundary", "outside")}, abs(power)


def truth_line_point_at(q):
    return {"point": written(at(point(q["line"]["origin"]), number(q["t"]), point(q["line"]["direction"])))}, None


def truth_orientation(q):
    (a, b), (c, d), (e, f) = point(q["p0"]), point(q["p1"]), point(q["p"])
    area = a * d + c * f + e * b - b * c - d * e - f * a
    return {"side": by_sign(area, "right", "on", "left")}, abs(area)


def truth_point_on_segment(q):
    p, ends = point(q["point"]), [point(end) for end in q["segment"]]
    v = minus(ends[1], ends[0])
    margin = squared_distance(p, ends[0], v, Fraction(1))
    on = in_common(p, (Fraction(0), Fraction(0)), Fraction(0), ends)
    return {"relation": "on", "t": str(parameter(p, ends[0], v))} if on else {"relation": "off"}, margin


def truth_line_line(q):
    (a, a_end), (b, b_end) = [[point(end) for end in q[name]] for name in "ab"]
    u, v = minus(a_end, a), minus(b_end, b)
    slope, height = cross(v, u), cross(v, minus(a, b))  # how far a + t u is from b's line
    if slope == 0:
        return {"relation": "same" if height == 0 else "parallel"}, Fraction(0)
    p = at(a, -height / slope, u)
    numbers = {"ta": str(-height / slope), "tb": str(parameter(p, b, v)), "point": written(p)}
    return {"relation": "crossing", **numbers}, abs(slope)


def truth_segment_segment(q):
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


def truth_ray_segment(q):
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
