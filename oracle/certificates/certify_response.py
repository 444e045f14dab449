# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of collision response: one function an operation, as in check_response.cpp."""

from certify_reading import expect
from certify_space import dot, exact_triple, point_in_space


def check_reflect_wall(claim):
    claim.inputs("velocity", "axis")
    before, axis = point_in_space(claim.input["velocity"], "velocity"), claim.input["axis"]
    expect(axis in ("x", "y", "z"), "axis: x, y or z")
    claim.answers("velocity")
    claim.expect_kind("components"), claim.facts("squared_speeds")
    after = exact_triple(claim.truth["velocity"], "truth.velocity")
    first, last = claim.pair("squared_speeds")
    expect((first, last) == (dot(before, before), dot(after, after)), "certificate: the squared speeds are wrong")
    expect(first == last, "truth: kinetic energy is not kept")
    moved = [to == (-v if name == axis else v) for name, v, to in zip("xyz", before, after)]
    expect(all(moved), "truth: velocity is wrong")
