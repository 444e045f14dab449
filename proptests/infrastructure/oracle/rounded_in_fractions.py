# SPDX-License-Identifier: Apache-2.0
"""Checks whether `rounded` of a test vector is its truth in doubles, by fractions and Python's division, which rounds integers
correctly: an opinion to compare certify_proved with, since certify and certify.py do not look at `rounded`."""
import math
import sys
from fractions import Fraction

from certify_reading import Refusal
from certify_surd import exact_surd

OUTWARDS = {"kdop_of_points": "slabs"}  # lists of pairs whose ends are rounded outwards
BY_CONTRACT = {"bounding_sphere"}  # the radius is the least around the center that is rounded: not looked at
PLACES = 6000  # binary ones of a root
GREATEST = sys.float_info.max


def bounds(text):
    """Returns bounds of the exact value, which are equal if it is a fraction."""
    x = exact_surd(text, "truth")
    square = x.r << 2 * PLACES
    root = math.isqrt(square)
    return [x.p + x.q * Fraction(root + more, 2**PLACES) for more in (0, root * root < square)]


def nearest(x):
    try:
        return x.numerator / x.denominator
    except OverflowError:
        return math.inf if x > 0 else -math.inf


def double(value):
    if isinstance(value, str):
        return {"inf": math.inf, "-inf": -math.inf}.get(value, math.nan)
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else math.nan


def rounds_to(text, value):
    low, high = map(nearest, bounds(text))
    if low != high:
        raise ArithmeticError(f"{text}: {PLACES} places are too few")
    return double(value) == low


def rounds_down_to(x, d):
    if math.isinf(d):
        return d < 0 and x < -GREATEST
    return d <= x and (d == GREATEST or x < math.nextafter(d, math.inf))


def rounds_outwards(truth, rounded):
    if not is_list(rounded, 2):
        return False
    (low, high), (below, above) = map(Fraction, truth), map(double, rounded)
    return rounds_down_to(low, below) and rounds_down_to(-high, -above)


def is_list(value, length):
    return isinstance(value, list) and len(value) == length


def is_word(text):
    return "a" <= text[:1] <= "z" and not text.startswith("sqrt(")


def same(truth, rounded):
    if isinstance(truth, dict):
        return isinstance(rounded, dict) and truth.keys() == rounded.keys() and all(
            same(truth[name], rounded[name]) for name in truth)
    if isinstance(truth, list):
        return is_list(rounded, len(truth)) and all(map(same, truth, rounded))
    return truth == rounded if is_word(truth) else rounds_to(truth, rounded)


def is_rounded(claim):
    """Returns whether `rounded` is right, for a claim whose truth holds; a claim without it claims nothing."""
    if "rounded" not in claim or claim["op"] in BY_CONTRACT:
        return True
    truth, rounded = claim["truth"], claim["rounded"]
    field = OUTWARDS.get(claim["op"])
    try:
        if field is None:
            return same(truth, rounded)
        slabs = rounded[field] if isinstance(rounded, dict) and rounded.keys() == {field} else None
        return is_list(slabs, len(truth[field])) and all(map(rounds_outwards, truth[field], slabs))
    except Refusal:
        return False
