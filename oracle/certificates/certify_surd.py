# SPDX-License-Identifier: Apache-2.0
"""Exact numbers with a square root, as in check_surd.cpp."""

import math
import re
from fractions import Fraction

from certify_reading import expect, expect_not_too_long

FRACTION = r"[0-9]+(?:/0*[1-9][0-9]*)?"
RATIONAL = re.compile(rf"-?{FRACTION}")
ROOTED = re.compile(rf"(?:(-?{FRACTION})(?=[+-]))?([+-]?)(?:({FRACTION})\*)?sqrt\(([0-9]+)\)")


class Surd:
    """p + q sqrt(r), r >= 0."""

    def __init__(self, p, q=0, r=0):
        self.p, self.q, self.r = p, q, r

    def __add__(self, other):
        if isinstance(other, Surd):  # over one root
            return Surd(self.p + other.p, self.q + other.q, self.r)
        return Surd(self.p + other, self.q, self.r)

    def __mul__(self, factor):
        return Surd(self.p * factor, self.q * factor, self.r)

    def square(self):
        return Surd(self.p**2 + self.q**2 * self.r, 2 * self.p * self.q, self.r)

    def sign(self):
        """By squares."""
        def of(x):
            return (x > 0) - (x < 0)

        of_p, of_root = of(self.p), of(self.q) * of(self.r)
        if of_p * of_root >= 0:
            return of_p or of_root
        return of_p * of(self.p**2 - self.q**2 * self.r)

    def compared_with(self, other):
        """The sign of the difference, also over different roots."""
        left = self + -other.p
        of_left, of_root = left.sign(), Surd(0, other.q, other.r).sign()
        if of_left != of_root:
            return 1 if of_left > of_root else -1
        return of_left * (left.square() + -(other.q**2) * other.r).sign()

    def has_square(self, square):
        return (self.square() + -square).sign() == 0


def is_square(value):
    return all(math.isqrt(part) ** 2 == part for part in (value.numerator, value.denominator))


def expect_kind_of_root(claim, rational):
    """The claim's kind is "root", or "irrational_root" where no rational number is the root."""
    claim.expect_kind("root" if rational else "irrational_root")


def exact_surd(value, what):
    malformed = what + ': an exact value "p/q" or "p+q*sqrt(r)"'
    expect(isinstance(value, str), malformed)
    expect_not_too_long(value, what)
    if RATIONAL.fullmatch(value):
        return Surd(Fraction(value))
    found = ROOTED.fullmatch(value)
    expect(found is not None, malformed)
    part, sign, size, radicand = found.groups()
    expect(part is not None or sign != "+", malformed)
    coefficient = Fraction(size or 1)
    return Surd(Fraction(part or 0), -coefficient if sign == "-" else coefficient, int(radicand))


def expect_distance(claim, square):
    """The squared distance, and its root, which is a fraction or is not, as the kind says."""
    expect(claim.exact("squared_distance") == square, "truth: squared_distance is wrong")
    distance = exact_surd(claim.truth["distance"], "truth.distance")
    expect(distance.sign() >= 0 and distance.has_square(square), "truth: distance is wrong")
    expect_kind_of_root(claim, is_square(square))
