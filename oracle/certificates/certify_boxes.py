# SPDX-License-Identifier: Apache-2.0
"""How certify.py reads axis-aligned boxes of the plane or of space, as check_boxes.cpp does."""

from certify_reading import expect, number, only


def corner(value, what):
    expect(isinstance(value, list) and len(value) in (2, 3), what + ": a list of two or three")
    return [number(coordinate, f"{what}[{axis}]") for axis, coordinate in enumerate(value)]


def box(value, what):
    """(min, max), two or three coordinates of each."""
    only(value, what, ["min", "max"])
    low, high = corner(value["min"], what + ".min"), corner(value["max"], what + ".max")
    expect(len(high) == len(low), what + ".max: as many coordinates as min")
    for axis, (least, greatest) in enumerate(zip(low, high)):
        expect(least <= greatest, f"{what}.max[{axis}]: min <= max")
    return low, high
