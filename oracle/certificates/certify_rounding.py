# SPDX-License-Identifier: Apache-2.0
"""Checks whether a claimed number stands for an irrational one between two bounds, as in check_rounding.cpp."""

from fractions import Fraction

from certify_reading import expect


def ulp_exponent(value):
    size = abs(value)
    order = size.numerator.bit_length() - size.denominator.bit_length()
    if size < Fraction(2) ** order:
        order -= 1
    return min(max(order - 52, -1074), 971)


def expect_rounds_alike(name, claimed, low, high):
    same_sign = claimed * low > 0 and claimed * high > 0
    expect(same_sign, f"truth: the sign of {name} is not proved")
    ulp = Fraction(2) ** ulp_exponent(claimed)
    close = ulp / 2**60
    expect(abs(claimed - low) < close and abs(claimed - high) < close, f"truth: {name} is too far off")
    nearest = {min(round(abs(value / ulp)), 1 << 53) for value in (low, claimed, high)}  # round: ties to even
    expect(len(nearest) == 1, f"truth: the rounding of {name} is not proved")
    expect(low <= claimed <= high, f"truth: {name} is not between its bounds")
