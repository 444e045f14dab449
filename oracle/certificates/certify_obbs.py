# SPDX-License-Identifier: Apache-2.0
"""How certify.py reads oriented boxes, and what it checks of them, as check_obbs.cpp does."""

from certify_reading import WRONG_KIND, expect, only
from certify_space import box_holds, box_in_space, dot, list_of_three, minus, point_in_space, triple
from certify_triangles import points, weighted


def obb(value, what):
    """(center, half axes)"""
    only(value, what, ["center", "half_axes"])
    center, name = point_in_space(value["center"], what + ".center"), what + ".half_axes"
    axes = list_of_three(value["half_axes"], name)
    u, v, w = axes = [point_in_space(axis, f"{name}[{k}]") for k, axis in enumerate(axes)]
    across = (v[1] * w[2] - v[2] * w[1], v[2] * w[0] - v[0] * w[2], v[0] * w[1] - v[1] * w[0])
    expect(dot(u, across) != 0, name + ": linearly independent")
    return center, axes


def at(box, coefficients):
    center, axes = box
    return tuple(center[k] + sum(c * axis[k] for c, axis in zip(coefficients, axes)) for k in range(3))


def reach(box, normal):
    return sum(abs(dot(normal, axis)) for axis in box[1])


def greatest(coefficients, name):
    expect(len(coefficients) == 3, f"certificate.{name}: a list of three")
    return max(map(abs, coefficients))


def check_point_in_obb(claim):
    claim.inputs("obb", "point")
    box, p = obb(claim.input["obb"], "obb"), point_in_space(claim.input["point"], "point")
    claim.answers("location")
    location = claim.word("location")
    if location == "outside":
        claim.expect_kind("separating_plane"), claim.facts("normal")
        normal = triple(claim, "normal")
        expect(dot(normal, minus(p, box[0])) > reach(box, normal), "certificate: the plane does not separate")
        return
    claim.expect_kind("coefficients"), claim.facts("coefficients")
    coefficients = claim.list("coefficients")
    growth = greatest(coefficients, "coefficients")
    expect(at(box, coefficients) == p, "certificate: the coefficients give another point")
    expect(growth <= 1, "certificate: the point is not in the box")
    expect(location == ("inside" if growth < 1 else "boundary"), "truth: location is wrong")


def check_along_normal(claim, whole, gap, growth):
    """The contact of a solid and a box, `whole` naming both: gap(normal) is how far the box is beyond the other along a
    normal; growth() requires a common point, and is less than 1 where that is inside, 1 at most where it is in both."""
    claim.answers("contact")
    contact = claim.word("contact")
    if contact == "disjoint":
        claim.expect_kind("separating_axis"), claim.facts("normal")
        expect(gap(triple(claim, "normal")) > 0, "certificate: the axis does not separate")
        return
    touching = contact == "touching"
    expect(touching or contact == "overlapping", "truth: contact is wrong")
    claim.expect_kind("supporting_axis" if touching else "common_interior_point")
    claim.facts("on_a", "on_b", *["normal"] * touching)
    found = growth()
    if touching:
        expect(found <= 1, f"certificate: the point is not in {whole}")
        normal = triple(claim, "normal")
        expect(any(normal) and gap(normal) == 0, "certificate: the axis does not support")
    else:
        expect(found < 1, f"certificate: the point is not inside {whole}")


def check_obb_obb(claim):
    claim.inputs("a", "b")
    a, b = obb(claim.input["a"], "a"), obb(claim.input["b"], "b")

    def growth():
        on_a, on_b = claim.list("on_a"), claim.list("on_b")
        found = max(greatest(on_a, "on_a"), greatest(on_b, "on_b"))
        expect(at(a, on_a) == at(b, on_b), "certificate: the coefficients give two points")
        return found

    check_along_normal(claim, "both boxes", lambda normal: dot(normal, minus(b[0], a[0])) - reach(a, normal)
                       - reach(b, normal), growth)


def check_triangle_obb(claim):
    claim.inputs("triangle", "obb")
    corners, box = points(claim.input["triangle"], "triangle", 3, "three"), obb(claim.input["obb"], "obb")

    def growth():
        weights, coefficients = claim.list("on_a"), claim.list("on_b")
        found = greatest(coefficients, "on_b")
        expect(len(weights) == 3, "certificate: as many weights as points")
        same = tuple(weighted(corners, weights)) == at(box, coefficients)
        expect(same, "certificate: the weights and coefficients give two points")
        return found

    check_along_normal(claim, "the box", lambda normal: dot(normal, box[0]) - reach(box, normal)
                       - max(dot(normal, p) for p in corners), growth)


AABB_OBB = {
    "disjoint": {"separating_axis": ("normal",)},
    "touching": {"supporting_axis": ("coefficients", "normal"), "flat_axis": ("coefficients", "axis")},
    "overlapping": {"common_interior_point": ("coefficients",)},
}


def check_aabb_obb(claim):
    claim.inputs("aabb", "obb")
    (low, high), other = box_in_space(claim.input["aabb"], "aabb"), obb(claim.input["obb"], "obb")
    claim.answers("contact")
    contact, kind = claim.word("contact"), claim.kind()
    expect(contact in AABB_OBB, "truth: contact is wrong")
    expect(kind in AABB_OBB[contact], WRONG_KIND)

    def gap(normal):
        most = sum(max(n * a, n * b) for n, a, b in zip(normal, low, high))
        return dot(normal, other[0]) - reach(other, normal) - most

    claim.facts(*AABB_OBB[contact][kind])
    if contact == "disjoint":
        expect(gap(triple(claim, "normal")) > 0, "certificate: the axis does not separate")
        return
    coefficients = claim.list("coefficients")
    growth, x = greatest(coefficients, "coefficients"), at(other, coefficients)
    if contact == "overlapping":
        expect(growth < 1, "certificate: the point is not inside both boxes")
        inside = all(least < y < most for least, y, most in zip(low, x, high))
        expect(inside, "certificate: the point is not inside the box")
        return
    expect(growth <= 1 and box_holds(low, high, x), "certificate: the point is not in both boxes")
    if kind == "flat_axis":
        axis = claim.single("axis")
        expect(axis in range(3) and low[int(axis)] == high[int(axis)], "certificate: the box is not flat on the axis")
        return
    normal = triple(claim, "normal")
    expect(any(normal) and gap(normal) == 0, "certificate: the axis does not support")
