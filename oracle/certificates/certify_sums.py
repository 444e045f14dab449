# SPDX-License-Identifier: Apache-2.0
"""Exact vectors over one denominator.

A fraction reduces itself after every step. Where the numbers are long, that takes most of the time, so checks that use
a claimed vector many times, or add many claimed numbers, compute with integers and one denominator and never reduce.
"""

from math import lcm


def over_one(values):
    """(integers, d > 0): the values are the integers divided by d."""
    bottom = lcm(*(value.denominator for value in values))
    return tuple(value.numerator * (bottom // value.denominator) for value in values), bottom


def direction(values):
    """Integers in the same direction."""
    return over_one(values)[0]


def times(factor, values):
    """(vector, d)"""
    wholes, bottom = over_one(values)
    return tuple(factor.numerator * x for x in wholes), factor.denominator * bottom


def plus(one, other):
    """Adds two (vector, d)."""
    (v, c), (w, d) = one, other
    if c == d:
        return tuple(x + y for x, y in zip(v, w)), c
    return tuple(x * d + y * c for x, y in zip(v, w)), c * d


def total(terms):
    """The sum of at least one (vector, d). It adds in pairs, so that few of the products are long."""
    while len(terms) > 1:
        terms = [plus(*terms[i : i + 2]) if i + 1 < len(terms) else terms[i] for i in range(0, len(terms), 2)]
    return terms[0]
