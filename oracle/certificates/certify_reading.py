# SPDX-License-Identifier: Apache-2.0
"""How certify.py reads claims: input numbers, exact values, and the shapes with their rules."""

import re
from fractions import Fraction

WRONG_KIND = "certificate: no such kind for this truth"


class Refusal(Exception):
    pass


def expect(holds, reason):
    if not holds:
        raise Refusal(reason)


def only(thing, what, names):
    expect(isinstance(thing, dict), what + ": an object")
    for name in names:
        expect(name in thing, f"{what}: field {name} is missing")
    expect(set(thing) == set(names), what + ": an unexpected field")


def binary64(value):
    if value == 0:
        return True
    top, bottom = abs(value.numerator), value.denominator
    low, high, scale = (top & -top).bit_length() - 1, top.bit_length(), bottom.bit_length() - 1
    return bottom & (bottom - 1) == 0 and high - low <= 53 and low - scale >= -1074 and high - scale <= 1024


NOT_FINITE = ("inf", "-inf", "nan")
# The order of members within a shape is alphabetical, except for these.
FIRST = ("origin", "min", "vertices", "mass", "inertia", "inverse_mass", "position", "velocity", "segment", "outer")


def rank(member):
    return (FIRST.index(member) if member in FIRST else len(FIRST), member)


def expect_finite(value, what):
    """Checks a whole field, in the order of its shape."""
    expect(not isinstance(value, str) or value not in NOT_FINITE, what + ": finite number")
    if isinstance(value, list):
        for i, part in enumerate(value):
            expect_finite(part, f"{what}[{i}]")
    elif isinstance(value, dict):
        for name in sorted(value, key=rank):
            expect_finite(value[name], f"{what}.{name}")


HEXADECIMAL = re.compile(r"([+-]?)0[xX]([0-9a-fA-F]*)(?:\.([0-9a-fA-F]*))?(?:[pP]([+-]?[0-9]{1,5}))?")


def number(value, what):
    malformed = what + ": a number or a hexadecimal float string"
    expect(value not in NOT_FINITE, what + ": finite number")
    if isinstance(value, str):
        found = HEXADECIMAL.fullmatch(value)
        expect(found is not None, malformed)
        sign, whole, part, power = found.group(1), found.group(2), found.group(3) or "", int(found.group(4) or 0)
        expect(0 < len(whole + part) <= 1000, malformed)
        exact = Fraction(int(whole + part, 16)) * Fraction(2) ** (power - 4 * len(part))
        expect(binary64(exact), what + ": a binary64 number")
        return -exact if sign == "-" else exact
    expect(isinstance(value, (int, float)) and not isinstance(value, bool), malformed)
    try:
        return Fraction(float(value))
    except (OverflowError, ValueError):
        raise Refusal(what + ": finite number") from None


def list_of_two(value, what):
    expect(isinstance(value, list) and len(value) == 2, what + ": a list of two")
    return value


def point(value, what):
    x, y = list_of_two(value, what)
    return number(x, what + "[0]"), number(y, what + "[1]")


def segment(value, what):
    a, b = list_of_two(value, what)
    return point(a, what + "[0]"), point(b, what + "[1]")


def line_of_two_points(value, what):
    a, b = segment(value, what)
    expect(a != b, what + ": two distinct points")
    return a, b


def ray(value, what):
    only(value, what, ["origin", "direction"])
    origin, direction = point(value["origin"], what + ".origin"), point(value["direction"], what + ".direction")
    expect(direction != (0, 0), what + ".direction: nonzero direction")
    return origin, direction


def circle(value, what):
    only(value, what, ["center", "radius"])
    center, radius = point(value["center"], what + ".center"), number(value["radius"], what + ".radius")
    expect(radius >= 0, what + ".radius: radius >= 0")
    return center, radius


def open_ring(ring, what):
    """The ring without a last position that repeats the first: it is dropped once."""
    opened = ring[:-1] if len(ring) > 1 and ring[0] == ring[-1] else ring
    expect(len(opened) >= 3, what + ": at least 3 vertices")
    return opened


def polygon(value, what):
    expect(isinstance(value, list), what + ": a list of vertices")
    return open_ring([point(vertex, f"{what}[{i}]") for i, vertex in enumerate(value)], what)


EXACT = re.compile(r"(-?[0-9]+)(?:/([0-9]+))?")


def expect_not_too_long(exact, what):
    expect(len(exact) <= 100_000, what + ": at most 100000 characters")


def exact_value(value, what):
    malformed = what + ': an exact value "p/q"'
    expect(isinstance(value, str), malformed)
    expect_not_too_long(value, what)
    found = EXACT.fullmatch(value)
    expect(found is not None, malformed)
    below = int(found.group(2) or 1)
    expect(below != 0, malformed)
    return Fraction(int(found.group(1)), below)


def exact_pair(value, what):
    x, y = list_of_two(value, what)
    return exact_value(x, what + "[0]"), exact_value(y, what + "[1]")


class Claim:
    def __init__(self, line):
        self.input, self.truth, self.certificate = line["input"], line["truth"], line["certificate"]

    def inputs(self, *names):
        """Every check says first which fields the input has, in the order of the contract: of all their numbers the
        first that is not finite is refused before any other rule."""
        only(self.input, "input", names)
        for name in names:
            expect_finite(self.input[name], name)

    def answers(self, *names):
        only(self.truth, "truth", names)

    def word(self, name):
        expect(isinstance(self.truth, dict) and isinstance(self.truth.get(name), str), f"truth: field {name} is missing")
        return self.truth[name]

    def exact(self, name):
        return exact_value(self.truth[name], "truth." + name)

    def exact_point(self):
        return exact_pair(self.truth["point"], "truth.point")

    def exact_overlap(self):
        overlap = list_of_two(self.truth["overlap"], "truth.overlap")
        return exact_pair(overlap[0], "truth.overlap[0]"), exact_pair(overlap[1], "truth.overlap[1]")

    def kind(self):
        held = isinstance(self.certificate, dict) and isinstance(self.certificate.get("kind"), str)
        expect(held, "certificate: field kind is missing")
        return self.certificate["kind"]

    def expect_kind(self, kind):
        expect(self.kind() == kind, WRONG_KIND)

    def facts(self, *names):
        given = self.certificate
        for name in names:
            expect(isinstance(given, dict) and name in given, f"certificate: field {name} is missing")
        size = len(given) if isinstance(given, (dict, list)) else given is not None
        expect(size == len(names) + 1, "certificate: an unexpected field")

    def single(self, name):
        value, what = self.certificate[name], "certificate." + name
        expect(isinstance(value, list) and len(value) == 1, what + ": a list of one")
        return exact_value(value[0], what + "[0]")

    def list(self, name):
        values, what = self.certificate[name], "certificate." + name
        expect(isinstance(values, list), what + ": a list")
        return [exact_value(value, f"{what}[{i}]") for i, value in enumerate(values)]

    def pair(self, name):
        return exact_pair(self.certificate[name], "certificate." + name)

    def proofs(self, name):
        """Those of parts of the claim."""
        values = self.certificate[name]
        expect(isinstance(values, list), f"certificate.{name}: a list")
        return [Claim({"input": self.input, "truth": self.truth, "certificate": value}) for value in values]
