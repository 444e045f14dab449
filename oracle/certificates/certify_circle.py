# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for a point on a circle, as in check_circle.cpp.

Pairs are whole numbers of some unit 2^-bits, low and high, with the true value between them.
"""

from fractions import Fraction

from certify_reading import circle, expect, number
from certify_rounding import expect_rounds_alike


def quotients(low, high, divisor):
    return low // divisor, -(-high // divisor)


def negated(x):
    return -x[1], -x[0]


def plus(total, term, sign):
    term = term if sign > 0 else negated(term)
    return total[0] + term[0], total[1] + term[1]


def arc_tangent_of_inverse(q, bits):
    """1/q - 1/(3 q^3) + ...: what is left out is smaller than the first term left out, at most one unit."""
    power, total, odd, sign = quotients(1 << bits, 1 << bits, q), (0, 0), 1, 1
    while (term := quotients(*power, odd))[1] > 1:
        total = plus(total, term, sign)
        power, odd, sign = quotients(*power, q * q), odd + 2, -sign
    return total[0] - 1, total[1] + 1


def machin(bits):
    fifth, small = arc_tangent_of_inverse(5, bits), arc_tangent_of_inverse(239, bits)
    return 16 * fifth[0] - 4 * small[1], 16 * fifth[1] - 4 * small[0]


def series(term, x, k, bits):
    """Sine (term = x, k = 2) or cosine (term = 1, k = 1) of x in [0, 1]: the terms fall and change sign."""
    total, sign = (0, 0), 1
    while term[1] > 1:
        total = plus(total, term, sign)
        term = quotients(term[0] * x[0] * x[0], term[1] * x[1] * x[1], k * (k + 1) << 2 * bits)
        k, sign = k + 2, -sign
    return total[0] - 1, total[1] + 1


def rest_of_turn(u, turns, bits):
    fine = bits + max(1, abs(turns).bit_length())
    low, high = machin(fine)
    if turns < 0:
        low, high = high, low
    low, high = (u - Fraction(turns * bound, 2 << fine) for bound in (high, low))
    return (low.numerator << bits) // low.denominator, -((-high.numerator << bits) // high.denominator)


def all_bits(bits):
    expect(bits.denominator == 1 and 1 <= bits <= 8192, "certificate: bits is not from 1 to 8192")
    return int(bits)


def cosine_and_sine(u, turns, bits):
    rest, one = rest_of_turn(u, turns, bits), 1 << bits
    negative = rest[1] <= 0
    x = negated(rest) if negative else rest
    expect(0 <= x[0] and x[1] <= one, "certificate: quarter_turns or bits do not fit u")
    c, s = series((one, one), x, 1, bits), series(x, x, 2, bits)
    s = negated(s) if negative else s
    return [(c, s), (negated(s), c), (negated(c), negated(s)), (s, negated(c))][turns % 4]


def expect_cosine_and_sine(u, cosine, sine, turns, bits):
    in_range = turns.denominator == 1 and abs(turns.numerator).bit_length() <= 1030
    expect(in_range, "certificate: quarter_turns is out of range")
    bits = all_bits(bits)
    computed = cosine_and_sine(u, int(turns), bits)
    for claimed, found, name in ((cosine, computed[0], "cosine"), (sine, computed[1], "sine")):
        encloses = claimed[0] * (1 << bits) <= found[0] and found[1] <= claimed[1] * (1 << bits)
        expect(encloses, f"certificate: {name} is wrong")


def check_parametric_circle(claim):
    claim.inputs("circle", "u")
    center, radius = circle(claim.input["circle"], "circle")
    u = number(claim.input["u"], "u")
    claim.answers("point")
    p = claim.exact_point()
    if claim.kind() == "exact":
        claim.facts(), expect(u == 0 or radius == 0, "certificate: neither u nor the radius is 0")
        expect(p == (center[0] + radius, center[1]), "truth: point is wrong")
        return
    claim.expect_kind("enclosure")
    expect(u != 0 and radius != 0, "certificate: the point is rational")
    claim.facts("cosine", "sine", "quarter_turns", "bits")
    cosine, sine = claim.pair("cosine"), claim.pair("sine")
    expect_cosine_and_sine(u, cosine, sine, claim.single("quarter_turns"), claim.single("bits"))
    for axis, unit in enumerate((cosine, sine)):
        expect_rounds_alike("point", p[axis], center[axis] + radius * unit[0], center[axis] + radius * unit[1])
