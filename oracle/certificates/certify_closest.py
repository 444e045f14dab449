# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for nearest points, and of the contacts that follow from them, as in check_closest.cpp."""

from itertools import product

from certify_meshes import mesh, outward_planes
from certify_obbs import at, greatest, obb
from certify_reading import WRONG_KIND, exact_value, expect, number, only
from certify_space import ball, box_holds, box_in_space, minus, plane, point_in_space, triple, two_or_three
from certify_surd import expect_distance


def dot(p, q):
    return sum(x * y for x, y in zip(p, q))


def is_lowest(low, high, slopes, x):
    """Why that is so stands in check_closest.cpp."""
    return all(not (n > 0 and y != a) and not (n < 0 and y != b) for a, b, n, y in zip(low, high, slopes, x))


def check_aabb_plane(claim):
    claim.inputs("aabb", "plane")
    (low, high), (normal, offset) = box_in_space(claim.input["aabb"], "aabb"), plane(claim.input["plane"], "plane")
    claim.answers("contact")
    contact, kind = claim.word("contact"), claim.kind()
    kinds = {"disjoint": ("lowest_point",), "touching": ("lowest_point", "flat_axis"),
             "overlapping": ("common_interior_point",)}
    expect(contact in kinds, "truth: contact is wrong")
    expect(kind in kinds[contact], WRONG_KIND)
    flat = kind == "flat_axis"
    claim.facts(*(("point", "axis") if flat else ("point",)))
    x = triple(claim, "point")
    height = dot(normal, x) + offset
    expect(box_holds(low, high, x), "certificate: the point is not in the box")
    if contact == "overlapping":
        inside = all(least < y < greatest for least, y, greatest in zip(low, x, high))
        expect(inside, "certificate: the point is not inside the box")
        expect(height < 0, "certificate: the point is not behind the plane")
    elif flat:
        expect(height <= 0, "certificate: the point is in front of the plane")
        axis = claim.single("axis")
        expect(axis in range(3) and low[int(axis)] == high[int(axis)], "certificate: the box is not flat on the axis")
    else:
        expect(is_lowest(low, high, normal, x), "certificate: a point of the box is lower")
        held = height > 0 if contact == "disjoint" else height == 0
        expect(held, "certificate: the height of the point proves another truth")


def hull(value, what, count, axes=None):
    """The ends of a segment, or the corners of a triangle: all that is between them."""
    named = {2: "two", 3: "three"}[count]
    expect(isinstance(value, list) and len(value) == count, f"{what}: a list of {named}")
    points = []
    for i, point in enumerate(value):
        points.append(two_or_three(point, f"{what}[{i}]"))
        expect(len(points[i]) == (axes or len(points[0])), f"{what}[{i}]: as many coordinates as the others")
    return points


def weighted(claim, fact, points):
    """The point of the hull that the fact's weights give."""
    weights = claim.list(fact)
    expect(len(weights) == len(points), "certificate: as many weights as points")
    expect(all(weight >= 0 for weight in weights), "certificate: a weight is negative")
    expect(sum(weights) == 1, "certificate: the weights do not add up to 1")
    return tuple(dot(weights, along_axis) for along_axis in zip(*points))


def expect_nearest(points, x, y):
    nearest = all(dot(minus(x, y), minus(p, x)) >= 0 for p in points)
    expect(nearest, "certificate: a point of the hull is nearer")


def expect_position(claim, name, x):
    value = claim.truth[name]
    expect(isinstance(value, list) and len(value) == len(x), f"truth.{name}: as many coordinates as the input")
    for axis, coordinate in enumerate(x):
        expect(exact_value(value[axis], f"truth.{name}[{axis}]") == coordinate, f"truth: {name} is wrong")


def expect_closest(claim, points, x, p):
    expect_nearest(points, x, p)
    expect_position(claim, "point", x)
    expect_distance(claim, dot(minus(x, p), minus(x, p)))


def closest_point(claim, shape, corners):
    claim.inputs("point", shape)
    p = two_or_three(claim.input["point"], "point")
    points = hull(claim.input[shape], shape, corners, len(p))
    expect(corners == 2 or len(p) == 3, "point: a list of three")
    claim.answers("point", "squared_distance", "distance")
    claim.facts("weights")
    expect_closest(claim, points, weighted(claim, "weights", points), p)


def check_closest_point_on_segment(claim):
    closest_point(claim, "segment", 2)


def check_closest_point_on_triangle(claim):
    closest_point(claim, "triangle", 3)


def expect_first(a, b, x, y):
    """Why there is no pair with a smaller parameter on a stands in check_closest.cpp."""
    v, w = minus(a[1], a[0]), minus(b[1], b[0])
    along = dot(v, w)
    if along == 0 or dot(v, v) * dot(w, w) != along**2 or x == a[0]:
        return
    expect(y == (b[0] if along > 0 else b[1]), "certificate: a pair with a smaller parameter on a is as near")


def check_segment_segment_distance(claim):
    claim.inputs("a", "b")
    a = hull(claim.input["a"], "a", 2)
    b = hull(claim.input["b"], "b", 2, len(a[0]))
    claim.answers("on_a", "on_b", "squared_distance", "distance")
    claim.facts("on_a", "on_b")
    x, y = weighted(claim, "on_a", a), weighted(claim, "on_b", b)
    expect_nearest(a, x, y), expect_nearest(b, y, x), expect_first(a, b, x, y)
    expect_position(claim, "on_a", x), expect_position(claim, "on_b", y)
    expect_distance(claim, dot(minus(x, y), minus(x, y)))


def convex_solid(claim, name):
    """The vertices of a mesh that is closed and convex."""
    vertices, faces = mesh(claim.input[name], name)
    outward_planes(vertices, faces, name)
    return vertices


def none_before(points, x, direction):
    return all(dot(direction, minus(p, x)) >= 0 for p in points)


def corners_of(claim, name):
    return hull(claim.input[name], name, 3, 3)


def check_distance_of(read, claim):
    """Checks two hulls, which `read` reads. Why no other nearest pair is nearer to the first vertex of a stands in
    check_closest.cpp."""
    claim.inputs("a", "b")
    a, b = read(claim, "a"), read(claim, "b")
    relation = claim.word("relation")
    expect(relation in ("apart", "meeting"), "truth: relation is wrong")
    if relation == "apart":
        claim.answers("relation", "on_a", "on_b", "squared_distance", "distance")
        claim.facts("on_a", "on_b", "first")
    else:
        claim.answers("relation", "squared_distance", "distance")
        expect(claim.kind() == "common_point", WRONG_KIND)
        claim.facts("on_a", "on_b")
    x, y = weighted(claim, "on_a", a), weighted(claim, "on_b", b)
    if relation == "meeting":
        expect(x == y, "certificate: the point is not in both")
        for name in ("squared_distance", "distance"):
            expect(claim.exact(name) == 0, f"truth: {name} is wrong")
        return
    expect_nearest(a, x, y), expect_nearest(b, y, x)
    expect(x != y, "certificate: the points prove another truth")
    first = claim.list("first")
    expect(len(first) == 3, "certificate.first: a list of three")
    proved = none_before(a, x, first) and none_before(b, y, minus(minus(x, a[0]), first))
    expect(proved, "certificate: a pair nearer to the first vertex of a may be as near")
    expect_position(claim, "on_a", x), expect_position(claim, "on_b", y)
    expect_distance(claim, dot(minus(x, y), minus(x, y)))


def check_convex_distance(claim):
    check_distance_of(convex_solid, claim)


def check_triangle_triangle_distance(claim):
    check_distance_of(corners_of, claim)


KINDS = {"disjoint": ("nearest_points",), "touching": ("tangent", "no_interior"), "overlapping": ("near_points",)}


class Round:
    """All that is no farther from a core than a radius. A core that counts as a solid by itself has none."""

    def __init__(self, core, radii, box=None, aligned=None):
        self.core, self.radii, self.box, self.aligned = core, radii, box, aligned

    def at(self, claim, fact):
        """The point of the core that a fact gives, by weights or coefficients."""
        if self.aligned is not None:
            place = claim.list(fact)
            expect(len(place) == 3, f"certificate.{fact}: a list of three")
            expect(box_holds(*self.aligned, place), "certificate: the point is not in the box")
            return place
        if self.box is None:
            return weighted(claim, fact, self.core)
        coefficients = claim.list(fact)
        growth = greatest(coefficients, fact)
        expect(growth <= 1, "certificate: the point is not in the box")
        return at(self.box, coefficients)


def round_ball(claim, name):
    center, radius = ball(claim.input[name], name)
    return Round([center], [radius])


def round_triangle(claim, name):
    return Round(hull(claim.input[name], name, 3, 3), [])


def round_capsule(claim, name):
    value = claim.input[name]
    only(value, name, ["segment", "radius"])
    segment, radius = hull(value["segment"], name + ".segment", 2, 3), number(value["radius"], name + ".radius")
    expect(radius >= 0, name + ".radius: radius >= 0")
    return Round(segment, [radius])


def round_box(claim, name):
    box = obb(claim.input[name], name)
    return Round([at(box, signs) for signs in product((-1, 1), repeat=3)], [], box)


def round_aabb(claim, name):
    low, high = box_in_space(claim.input[name], name)
    return Round([list(corner) for corner in product(*zip(low, high))], [], aligned=(low, high))


def round_convex(claim, name):
    return Round(convex_solid(claim, name), [])


def is_flat(solid):
    return solid.aligned is not None and any(low == high for low, high in zip(*solid.aligned))


def expect_contact(claim, a, x, b, y):
    """The contact of two round solids, or of one and a triangle, from points of their cores."""
    radii = a.radii + b.radii
    kind = claim.kind()
    interiors = all(radius > 0 for radius in radii) and not is_flat(a) and not is_flat(b)
    beyond = dot(minus(x, y), minus(x, y)) - sum(radii) ** 2
    if kind == "near_points":
        expect(beyond < 0 and interiors, "certificate: the points are no common interior")
    elif kind == "no_interior":
        expect(beyond <= 0 and not interiors, "certificate: the points do not touch, or there are interiors")
    else:
        expect_nearest(a.core, x, y), expect_nearest(b.core, y, x)
        held = beyond == 0 if kind == "tangent" else beyond > 0
        expect(held, "certificate: the distance proves another truth")


def check_contact(claim, a, b):
    claim.answers("contact")
    contact, kind = claim.word("contact"), claim.kind()
    expect(contact in KINDS, "truth: contact is wrong")
    expect(kind in KINDS[contact], WRONG_KIND)
    if len(a.core) == 1:
        fact = "weights" if b.box is None else "coefficients"
        claim.facts(fact)
        expect_contact(claim, a, a.core[0], b, b.at(claim, fact))
    else:
        claim.facts("on_a", "on_b")
        x, y = a.at(claim, "on_a"), b.at(claim, "on_b")
        expect_contact(claim, a, x, b, y)


def check_closest_point_on_obb(claim):
    claim.inputs("point", "obb")
    p, box = point_in_space(claim.input["point"], "point"), round_box(claim, "obb")
    claim.answers("point", "squared_distance", "distance")
    claim.facts("coefficients")
    expect_closest(claim, box.core, box.at(claim, "coefficients"), p)


def contact(a, read_a, b, read_b):
    """The check of the contact of two inputs, which are read so."""

    def check(claim):
        claim.inputs(a, b)
        check_contact(claim, read_a(claim, a), read_b(claim, b))

    return check


check_sphere_triangle = contact("sphere", round_ball, "triangle", round_triangle)
check_sphere_capsule = contact("sphere", round_ball, "capsule", round_capsule)
check_capsule_capsule = contact("a", round_capsule, "b", round_capsule)
check_sphere_obb = contact("sphere", round_ball, "obb", round_box)
check_capsule_obb = contact("capsule", round_capsule, "obb", round_box)
check_capsule_aabb = contact("capsule", round_capsule, "aabb", round_aabb)
check_capsule_triangle = contact("capsule", round_capsule, "triangle", round_triangle)
check_sphere_convex = contact("sphere", round_ball, "mesh", round_convex)
check_capsule_convex = contact("capsule", round_capsule, "mesh", round_convex)
