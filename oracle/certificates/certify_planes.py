# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for points, polygons and planes in space: one function an operation, as in check_planes.cpp."""

from certify_reading import exact_value, expect, only
from certify_space import dot, exact_triple, list_of_three, plane, point_in_space, polygon_in_space
from certify_surd import exact_surd, expect_kind_of_root, is_square


def sign(value):
    return (value > 0) - (value < 0)


def expect_root(name, claimed, height, squared_length):
    """The number called `name` is height / sqrt(squared_length)."""
    held = claimed.sign() == sign(height) and claimed.has_square(height**2 / squared_length)
    expect(held, f"truth: {name} is wrong")


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
    for axis, part in enumerate(list_of_three(claim.truth["unit"], "truth.unit")):
        expect_root("unit", exact_surd(part, f"truth.unit[{axis}]"), normal[axis], length)
    expect_kind_of_root(claim, is_square(length)), claim.facts()


def check_point_plane(claim):
    claim.inputs("plane", "point")
    normal, offset = plane(claim.input["plane"], "plane")
    p = point_in_space(claim.input["point"], "point")
    claim.answers("side", "signed_distance")
    height, length = dot(normal, p) + offset, dot(normal, normal)
    side = "back" if height < 0 else "front" if height > 0 else "on"
    expect(claim.word("side") == side, "truth: side is wrong")
    claim.facts()
    expect_root("signed_distance", exact_surd(claim.truth["signed_distance"], "truth.signed_distance"), height, length)
    expect_kind_of_root(claim, height == 0 or is_square(length))


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
