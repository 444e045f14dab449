# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of points, polygons and planes in space: one function an operation, as in check_planes.cpp."""

import math

from certify_reading import exact_value, expect, only
from certify_rounding import expect_rounds_alike
from certify_space import dot, exact_triple, plane, point_in_space, polygon_in_space, triple


def sign(value):
    return (value > 0) - (value < 0)


def expect_root(name, claimed, height, squared_length):
    held = sign(claimed) == sign(height) and claimed**2 * squared_length == height**2
    expect(held, f"truth: {name} is wrong")


def is_square(value):
    return all(math.isqrt(part) ** 2 == part for part in (value.numerator, value.denominator))


def expect_root_enclosed(name, claimed, low, high, height, squared_length):
    inner, outer = (high, low) if height < 0 else (low, high)
    alike = height != 0 and sign(low) == sign(high) == sign(height) and low <= high
    held = alike and inner**2 * squared_length <= height**2 <= outer**2 * squared_length
    expect(held, f"certificate: the bounds of {name} are wrong")
    expect(not is_square(squared_length), "certificate: the root is rational")
    expect_rounds_alike(name, claimed, low, high)


def check_point_ground_plane(claim):
    claim.inputs("point")
    p = point_in_space(claim.input["point"], "point")
    claim.answers("side")
    claim.expect_kind("height"), claim.facts("height")
    height = claim.single("height")
    expect(height == p[1], "certificate: the height is wrong")
    side = "below" if height < 0 else "above" if height > 0 else "on"
    expect(claim.word("side") == side, "truth: side is wrong")


def newell_sum(ring):
    total = [0, 0, 0]
    for p, q in zip(ring, ring[1:] + ring[:1]):
        for axis in range(3):
            b, c = (axis + 1) % 3, (axis + 2) % 3
            total[axis] += p[b] * q[c] - p[c] * q[b]
    return tuple(total)


def check_polygon_normal(claim):
    claim.inputs("polygon")
    normal = newell_sum(polygon_in_space(claim.input["polygon"], "polygon"))
    length = dot(normal, normal)
    if claim.word("class") == "degenerate":
        claim.answers("class"), claim.expect_kind("no_area"), claim.facts()
        expect(length == 0, "truth: class is wrong")
        return
    expect(claim.word("class") == "proper" and length != 0, "truth: class is wrong")
    claim.answers("class", "normal", "unit")
    expect(exact_triple(claim.truth["normal"], "truth.normal") == normal, "truth: normal is wrong")
    unit = exact_triple(claim.truth["unit"], "truth.unit")
    if claim.kind() != "enclosure":
        claim.expect_kind("root"), claim.facts()
        for part, whole in zip(unit, normal):
            expect_root("unit", part, whole, length)
        return
    claim.facts("low", "high")
    for part, whole, low, high in zip(unit, normal, triple(claim, "low"), triple(claim, "high")):
        if whole == 0:
            expect(part == 0, "truth: unit is wrong")
        else:
            expect_root_enclosed("unit", part, low, high, whole, length)


def check_point_plane(claim):
    claim.inputs("plane", "point")
    normal, offset = plane(claim.input["plane"], "plane")
    p = point_in_space(claim.input["point"], "point")
    claim.answers("side", "signed_distance")
    height, length = dot(normal, p) + offset, dot(normal, normal)
    side = "back" if height < 0 else "front" if height > 0 else "on"
    expect(claim.word("side") == side, "truth: side is wrong")
    distance = claim.exact("signed_distance")
    if claim.kind() == "enclosure":
        claim.facts("distance")
        expect_root_enclosed("signed_distance", distance, *claim.pair("distance"), height, length)
    else:
        claim.expect_kind("root"), claim.facts()
        expect_root("signed_distance", distance, height, length)


def check_point_plane_toi(claim):
    claim.inputs("plane", "start", "end")
    normal, offset = plane(claim.input["plane"], "plane")
    start, end = point_in_space(claim.input["start"], "start"), point_in_space(claim.input["end"], "end")
    claim.answers("option_1", "option_2")
    claim.expect_kind("heights"), claim.facts("heights")
    e0, e1 = claim.pair("heights")
    expect((e0, e1) == (dot(normal, start) + offset, dot(normal, end) + offset), "certificate: the heights are wrong")

    def hits(option):
        answer, what = claim.truth[option], "truth." + option
        timed = isinstance(answer, dict) and "t" in answer
        only(answer, what, ["relation", "t", "point"] if timed else ["relation"])
        expect(answer["relation"] in ("hit", "never"), what + ": relation is wrong")
        return answer["relation"] == "hit", timed

    expect(hits("option_1") == (e1 <= 0, False), "truth: option_1 is wrong")
    hit = e0 <= 0 or e1 <= 0
    expect(hits("option_2") == (hit, hit), "truth: option_2 is wrong")
    if hit:
        t = exact_value(claim.truth["option_2"]["t"], "truth.option_2.t")
        first = t == 0 if e0 <= 0 else 0 < t <= 1 and e0 + t * (e1 - e0) == 0
        expect(first, "truth: t is wrong")
        point = exact_triple(claim.truth["option_2"]["point"], "truth.option_2.point")
        expect(point == tuple(p + t * (q - p) for p, q in zip(start, end)), "truth: point is not at t")
