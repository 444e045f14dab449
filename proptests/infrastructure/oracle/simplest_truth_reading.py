# SPDX-License-Identifier: Apache-2.0
"""Shared parts of the second truths: numbers and points as JSON has them, vectors, intervals of a parameter."""
from fractions import Fraction
from math import isqrt

ENDLESS = None


def number(value):
    return Fraction(float.fromhex(value)) if isinstance(value, str) else Fraction(value)


def point(value):
    """Returns a point of the plane or of space as a tuple of fractions."""
    return tuple(map(number, value))


def triangles(mesh):
    """Returns the triangles of a mesh: those of its cut where faces are polygons."""
    return mesh.get("cut", mesh["faces"])


def named_triangles(mesh):
    """Returns (face, triangle) for each triangle: the place of the face of which it is a part."""
    return zip((i for i, face in enumerate(mesh["faces"]) for _ in face[2:]), triangles(mesh))


def minus(p, q):
    return tuple(x - y for x, y in zip(p, q))


def dot(p, q):
    return sum(x * y for x, y in zip(p, q))


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
        low = max(low, Fraction(-height, slope))
    elif slope < 0:
        high = Fraction(-height, slope) if high is ENDLESS else min(high, Fraction(-height, slope))
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


class Root:
    """A square root with a sign, times a rational: equal to it is what is exactly it, "p/q" or "q*sqrt(r)"."""

    def __init__(self, square, sign):
        self.square, self.sign = square, sign

    def __repr__(self):
        return f"{self.sign} sqrt({self.square})"

    def __eq__(self, said):
        factor, root, radicand = said.partition("sqrt(")
        if not root:
            value = self.sign * Fraction(said)
            return value >= 0 and value**2 == self.square
        size = Fraction({"": "1", "-": "-1"}.get(factor, factor.removesuffix("*")))
        square = size**2 * int(radicand.removesuffix(")"))
        rational = all(isqrt(part) ** 2 == part for part in (square.numerator, square.denominator))
        return self.sign * size > 0 and not rational and square == self.square
