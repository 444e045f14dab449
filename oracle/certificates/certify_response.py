# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of collision response: one function an operation, as in check_response.cpp."""

from certify_bodies import cross, minus, normal, plus, times
from certify_reading import expect, number
from certify_space import dot, exact_triple, point_in_space, triple


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


def expect_decomposition(claim, v, n, k):
    claim.answers("velocity")
    claim.expect_kind("decomposition"), claim.facts("along", "across")
    after = exact_triple(claim.truth["velocity"], "truth.velocity")
    u, w = triple(claim, "along"), triple(claim, "across")
    expect(plus(u, w) == v, "certificate: the parts do not make up the velocity")
    expect(cross(u, n) == (0, 0, 0), "certificate: along is not along the normal")
    expect(dot(w, n) == 0, "certificate: across is not across the normal")
    expect(after == minus(w, times(k, u)), "truth: velocity is wrong")


def check_reflect_plane(claim):
    claim.inputs("velocity", "normal")
    v, n = point_in_space(claim.input["velocity"], "velocity"), normal(claim.input["normal"], "normal")
    expect_decomposition(claim, v, n, 1)


def check_damped_reflection(claim):
    claim.inputs("velocity", "normal", "k")
    v, n = point_in_space(claim.input["velocity"], "velocity"), normal(claim.input["normal"], "normal")
    expect_decomposition(claim, v, n, number(claim.input["k"], "k"))
