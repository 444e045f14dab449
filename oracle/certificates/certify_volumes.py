# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for bounding volumes, one function for each operation, as in check_volumes.cpp."""

from certify_reading import WRONG_KIND, exact_value, expect
from certify_space import ball_or_disc, box, box_holds, two_or_three


def axis_of(claim, axes):
    axis = claim.single("axis")
    expect(axis in range(axes), "certificate.axis: no axis of the boxes")
    return int(axis)


def point_of(claim, axes):
    point = claim.list("point")
    expect(len(point) == axes, "certificate.point: as many coordinates as the boxes")
    return point


def holds_inside(low, high, point):
    return all(least < p < greatest for least, p, greatest in zip(low, point, high))


def check_aabb_aabb(claim):
    claim.inputs("a", "b")
    a, b = box(claim.input["a"], "a"), box(claim.input["b"], "b")
    axes = len(a[0])
    expect(len(b[0]) == axes, "b: as many coordinates as a")
    claim.answers("contact")
    (a_min, a_max), (b_min, b_max) = a, b
    contact = claim.word("contact")
    if contact == "disjoint":
        claim.expect_kind("separating_axis"), claim.facts("axis", "value")
        k, value = axis_of(claim, axes), claim.single("value")
        separated = a_max[k] < value < b_min[k] or b_max[k] < value < a_min[k]
        expect(separated, "certificate: the axis does not separate")
    elif contact == "touching":
        flat = claim.kind() == "flat_axis"
        expect(flat or claim.kind() == "supporting_axis", WRONG_KIND)
        claim.facts("point", "axis")
        point = point_of(claim, axes)
        expect(box_holds(*a, point) and box_holds(*b, point), "certificate: the point is not in both boxes")
        k = axis_of(claim, axes)
        if flat:
            expect(a_min[k] == a_max[k] or b_min[k] == b_max[k], "certificate: no box is flat on the axis")
        else:
            supported = a_max[k] <= point[k] <= b_min[k] or b_max[k] <= point[k] <= a_min[k]
            expect(supported, "certificate: the axis does not support")
    else:
        expect(contact == "overlapping", "truth: contact is wrong")
        claim.expect_kind("common_interior_point"), claim.facts("point")
        point = point_of(claim, axes)
        expect(holds_inside(*a, point) and holds_inside(*b, point), "certificate: the point is not inside both boxes")


def check_closest_point_on_aabb(claim):
    claim.inputs("point", "aabb")
    p, (low, high) = two_or_three(claim.input["point"], "point"), box(claim.input["aabb"], "aabb")
    axes = len(p)
    expect(len(low) == axes, "aabb: as many coordinates as point")
    claim.answers("point")
    answer = claim.truth["point"]
    expect(isinstance(answer, list) and len(answer) == axes, "truth.point: as many coordinates as the box")
    x = [exact_value(value, f"truth.point[{k}]") for k, value in enumerate(answer)]
    claim.expect_kind("multipliers"), claim.facts("lower", "upper")
    lower, upper = claim.list("lower"), claim.list("upper")
    expect(len(lower) == len(upper) == axes, "certificate: as many multipliers as coordinates")
    expect(box_holds(low, high, x), "truth: the point is not in the box")
    for k in range(axes):
        expect(lower[k] >= 0 and upper[k] >= 0, "certificate: a multiplier is negative")
        attained = lower[k] == 0 or x[k] == low[k], upper[k] == 0 or x[k] == high[k]
        expect(all(attained), "certificate: a multiplier of a bound that is not attained")
        expect(x[k] - p[k] == lower[k] - upper[k], "certificate: the multipliers do not balance")


def squared_distance(p, q):
    return sum((x - y) ** 2 for x, y in zip(p, q))


def check_sphere_sphere(claim):
    claim.inputs("a", "b")
    (p, r), (q, s) = ball_or_disc(claim.input["a"], "a"), ball_or_disc(claim.input["b"], "b")
    expect(len(q) == len(p), "b: as many coordinates as a")
    claim.answers("contact")
    distance, reach = squared_distance(p, q), (r + s) ** 2
    contact, kind = claim.word("contact"), claim.kind()
    if contact == "disjoint":
        claim.expect_kind("distance"), claim.facts("squared_distance")
        expect(claim.single("squared_distance") == distance, "certificate: the squared distance is wrong")
        expect(distance > reach, "certificate: the balls are not apart")
        return
    touching = contact == "touching"
    expect(touching or contact == "overlapping", "truth: contact is wrong")
    expect(kind in (("tangent", "no_interior") if touching else ("common_interior_point",)), WRONG_KIND)
    claim.facts("point")
    point = claim.list("point")
    expect(len(point) == len(p), "certificate.point: as many coordinates as the centers")
    beyond_a, beyond_b = squared_distance(p, point) - r**2, squared_distance(q, point) - s**2
    if not touching:
        expect(beyond_a < 0 and beyond_b < 0, "certificate: the point is not inside both balls")
        return
    expect(beyond_a <= 0 and beyond_b <= 0, "certificate: the point is not in both balls")
    if kind == "tangent":
        expect(distance == reach, "certificate: the balls are not tangent")
    else:
        expect(r == 0 or s == 0, "certificate: both balls have an interior")


def is_nearest(low, high, p, x):
    """Why that is so stands in check_volumes.cpp."""
    return all(not (q < y != least) and not (q > y != greatest) for least, q, y, greatest in zip(low, p, x, high))


def check_sphere_aabb(claim):
    claim.inputs("sphere", "aabb")
    (center, radius), (low, high) = ball_or_disc(claim.input["sphere"], "sphere"), box(claim.input["aabb"], "aabb")
    axes = len(center)
    expect(len(low) == axes, "aabb: as many coordinates as sphere")
    claim.answers("contact")
    contact, kind = claim.word("contact"), claim.kind()
    touching = "flat_axis", "tangent"
    kinds = {"disjoint": ("nearest_point",), "touching": touching, "overlapping": ("common_interior_point",)}
    expect(contact in kinds, "truth: contact is wrong")
    expect(kind in kinds[contact], WRONG_KIND)
    flat = kind == "flat_axis"
    claim.facts(*(("point", "axis") if flat else ("point",)))
    point = point_of(claim, axes)
    beyond = squared_distance(center, point) - radius**2
    if contact == "overlapping":
        expect(holds_inside(low, high, point) and beyond < 0, "certificate: the point is not inside both")
        return
    expect(box_holds(low, high, point), "certificate: the point is not in the box")
    if flat:
        expect(beyond <= 0, "certificate: the point is not in the ball")
        k = axis_of(claim, axes)
        expect(low[k] == high[k], "certificate: the box is not flat on the axis")
        return
    expect(is_nearest(low, high, center, point), "certificate: a point of the box is nearer")
    if contact == "disjoint":
        expect(beyond > 0, "certificate: the point is in the ball")
    else:
        expect(beyond == 0, "certificate: the point is not on the boundary of the ball")
