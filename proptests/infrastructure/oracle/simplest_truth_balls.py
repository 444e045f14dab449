# SPDX-License-Identifier: Apache-2.0
"""The second truth of balls around points, in the style of simplest_truth.py."""
from fractions import Fraction
from itertools import combinations
from math import isqrt

from simplest_truth_reading import dot, minus, point

DIGITS = 4000  # binary, behind the point, of roots


class RootOf:
    """The root of a square, not negative; equal to it is its text, "q*sqrt(r)" or rational."""

    def __init__(self, square):
        self.square = square

    def __repr__(self):
        return f"sqrt({self.square})"

    def __eq__(self, said):
        lead, _, radicand = said.partition("sqrt(")
        factor = Fraction(lead.removesuffix("*") or 1) if radicand else Fraction(lead)
        return factor >= 0 and factor * factor * Fraction(radicand.removesuffix(")") or 1) == self.square


class Near:
    """A number that is known up to a part in 2^200 of a size."""

    def __init__(self, value, size):
        self.value, self.room = value, size / 2**200

    def __repr__(self):
        return f"about {float(self.value)}"

    def __eq__(self, said):
        return abs(self.value - Fraction(said)) <= self.room


def root(square):
    return Fraction(isqrt(int(square * 4**DIGITS)), 2**DIGITS)


def squared(p, q):
    return dot(minus(p, q), minus(p, q))


def farthest(center, points):
    return max(squared(center, p) for p in points)


def solved(rows):
    """The one solution of linear equations, the right side last in each row; None where there is not one."""
    rows, n = [row[:] for row in rows], len(rows)
    for i in range(n):
        pivot = next((k for k in range(i, n) if rows[k][i] != 0), None)
        if pivot is None:
            return None
        rows[i], rows[pivot] = rows[pivot], rows[i]
        rows[i] = [x / rows[i][i] for x in rows[i]]
        for k in range(n):
            if k != i:
                rows[k] = [x - rows[k][i] * y for x, y in zip(rows[k], rows[i])]
    return [row[-1] for row in rows]


def smallest_of_few(points):
    """Returns the smallest ball through up to four points, with its center in their affine hull, that contains all."""
    least = None
    for size in range(1, 5):
        for first, *others in combinations(points, size):
            ways = [minus(p, first) for p in others]
            weights = solved([[2 * dot(v, w) for w in ways] + [dot(v, v)] for v in ways])
            if weights is None:
                continue
            center = tuple(x + sum(t * v[k] for t, v in zip(weights, ways)) for k, x in enumerate(first))
            square = squared(center, first)
            if (least is None or square < least[1]) and farthest(center, points) <= square:
                least = center, square
    return least


def smallest(points):
    """Takes the ball of some of the points, and adds the point farthest outside until none is outside."""
    some = [points[0]]
    while True:
        center, square = smallest_of_few(some)
        last = max(points, key=lambda p: squared(center, p))
        if squared(center, last) <= square:
            return center, square
        some.append(last)


def grown(points):
    pairs = [(points[0], points[0])]
    for axis in range(3):
        pairs.append((min(points, key=lambda p: p[axis]), max(points, key=lambda p: p[axis])))
    a, b = max(pairs, key=lambda pair: squared(*pair))
    center, radius = tuple((x + y) / 2 for x, y in zip(a, b)), root(squared(a, b) / 4)
    for p in points:
        if squared(center, p) > radius**2:
            distance = root(squared(center, p))
            part = (distance - radius) / (2 * distance)
            center = tuple(round((x + part * (y - x)) * 2**DIGITS) / Fraction(2**DIGITS) for x, y in zip(center, p))
            radius = (radius + distance) / 2
    return center, radius


def truth_bounding_sphere(q):
    """The method as it is defined. Nothing is decided, so there is no margin."""
    points, method = [point(p) for p in q["points"]], q.get("method", "smallest")
    axes = list(zip(*points))
    if method == "ritter":
        size = max(abs(x) for axis in axes for x in axis)
        center, radius = grown(points)
        return {"sphere": {"center": [Near(x, size) for x in center], "radius": Near(radius, size)}}, None
    if method == "smallest":
        center, square = smallest(points)
    else:
        middle = (lambda x: (min(x) + max(x)) / 2) if method == "box" else (lambda x: sum(x) / len(x))
        center = tuple(map(middle, axes))
        square = farthest(center, points)
    return {"sphere": {"center": [str(x) for x in center], "radius": RootOf(square)}}, None
