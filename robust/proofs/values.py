# SPDX-License-Identifier: Apache-2.0
"""The values that a function of the headers is run on; see extract.py."""
import re

TYPES = {
    "Vector2": "x y", "Point2": "x y", "Vector3": "x y z", "Point3": "x y z", "Segment2": "a:Point2 b:Point2",
    "Sphere3": "center:Point3 radius", "Plane": "normal:Vector3 offset", "Slab": "min max",
    "BeyondInterval": "beyond extent",
    "MovingBody": "position:Point3 velocity:Vector3 angular_velocity:Vector3",
    "Obb3": "center:Point3 half_axes:HalfAxes", "HalfAxes": "u:Vector3 v:Vector3 w:Vector3",
}


class Number:
    """A computed number: its name, and the factors if it is their product (a compiler may contract it)."""

    def __init__(self, name, factors=None):
        self.name, self.factors = name, factors

    def __str__(self):
        return self.name


class Real(str):
    """A constant, as a real number."""


class Truth(str):
    """A Coq boolean."""


class Answer(str):
    """A Coq answer."""


class Index(str):
    """An index of an array, as a natural number."""


class Array:
    """An array whose elements are found by an index: a function of natural numbers, or one for each coordinate."""

    def __init__(self, name, kind):
        self.name, self.kind = name, kind

    @staticmethod
    def shown(index):
        return index if isinstance(index, Index) else f"{index}%nat"

    def __getitem__(self, index):
        if self.kind == "std::size_t":
            return Index(f"({self.name} {self.shown(index)})")
        if self.kind == "Float":
            return Number(f"({self.name} {self.shown(index)})")
        return {f: Number(f"({self.name}_{f} {self.shown(index)})") for f in TYPES[self.kind].split()}


def chosen_bounds(body, otherwise):
    found = re.search(r"using B = (\w+);", body)
    return found[1] if found else otherwise


def fits(kind, argument):
    return isinstance(argument, dict) == (kind in TYPES) and (
        kind not in TYPES or [f.split(":")[0] for f in TYPES[kind].split()] == list(argument))


def exponents(operator, left, right):
    """(number, symbols): an integer plus exponents of the format."""
    if operator == "*":
        k = left[0] if not left[1] else right[0]
        other = right if not left[1] else left
        return (k * other[0], other[1] * k)
    if operator == "/":
        return (0, (f"{left[1][0]}/{right[0]}",))
    return (left[0] + right[0], left[1] + right[1])


POWERS = {
    "min_exponent": "n F", "max_exponent/3": "third F", "max_exponent/4": "quarter F", "max_exponent/6": "sixth F"}


def power(exponent):
    if not exponent[1]:
        return f"(two_to ({exponent[0]}))"
    symbols = [POWERS[s] for s in exponent[1]]
    text = " * ".join(symbols)
    if len(symbols) > 1 and symbols[0] == "n F":
        text = f"n F * ({' * '.join(symbols[1:])})"
    return f"({2 ** exponent[0]} * ({text}))" if exponent[0] else f"({text})"
