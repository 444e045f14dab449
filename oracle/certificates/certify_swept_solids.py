# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for convex solids that move along straight lines, as in check_swept_solids.cpp."""

from certify_meshes import mesh, outward_planes
from certify_obbs import obb, reach
from certify_reading import WRONG_KIND, exact_value, expect, number
from certify_space import box, box_holds, cross, point_in_space
from certify_sums import direction, over_one


def dot(p, q):
    return sum(x * y for x, y in zip(p, q))


class BoxSolid:
    def __init__(self, low, high):
        self.low, self.high = low, high

    def holds(self, p):
        return box_holds(self.low, self.high, p)

    def highest(self, normal):
        return sum(n * (high if n > 0 else low) for n, low, high in zip(normal, self.low, self.high))


def check_swept_aabb_aabb(claim):
    claim.inputs("a", "b", "velocity")
    a, b = BoxSolid(*box(claim.input["a"], "a")), BoxSolid(*box(claim.input["b"], "b"))
    axes = len(a.low)
    expect(len(b.low) == axes, "b: as many coordinates as a")
    velocity = claim.input["velocity"]
    expect(isinstance(velocity, list) and len(velocity) == axes, "velocity: as many coordinates as a")
    prove_first_contact(claim, a, b, [number(v, f"velocity[{k}]") for k, v in enumerate(velocity)])


class MeshSolid:
    def __init__(self, claim, name):
        self.vertices, faces = mesh(claim.input[name], name)
        self.planes = outward_planes(self.vertices, faces, name)

    def holds(self, p):
        around, scale = over_one(p)
        return all(dot(normal, around) + offset * scale <= 0 for normal, offset in self.planes)

    def highest(self, normal):
        return max(dot(normal, vertex) for vertex in self.vertices)


def check_swept_convex_polyhedra(claim):
    claim.inputs("a", "b", "velocity")
    a, b = MeshSolid(claim, "a"), MeshSolid(claim, "b")
    prove_first_contact(claim, a, b, point_in_space(claim.input["velocity"], "velocity"))


class ObbSolid:
    """Which planes these are stands in check_swept_solids.cpp."""

    def __init__(self, box):
        self.box = box

    def holds(self, p):
        center, axes = self.box
        way = [x - c for x, c in zip(p, center)]
        normals = [cross(axes[k - 2], axes[k - 1]) for k in range(3)]
        return all(abs(dot(normal, way)) <= abs(dot(normal, axis)) for normal, axis in zip(normals, axes))

    def highest(self, normal):
        return dot(normal, self.box[0]) + reach(self.box, normal)


def check_swept_obb_obb(claim):
    claim.inputs("a", "b", "velocity")
    a, b = ObbSolid(obb(claim.input["a"], "a")), ObbSolid(obb(claim.input["b"], "b"))
    prove_first_contact(claim, a, b, point_in_space(claim.input["velocity"], "velocity"))


def fact(claim, name, size):
    coordinates = claim.list(name)
    expect(len(coordinates) == size, f"certificate.{name}: as many coordinates as the velocity")
    return coordinates


def lowest(solid, normal):
    return -solid.highest([-n for n in normal])


def prove_first_contact(claim, a, b, velocity):
    """Why each kind proves it stands in check_swept_solids.h."""
    relation, kind, size = claim.word("relation"), claim.kind(), len(velocity)
    if relation == "never":
        claim.answers("relation")
        claim.expect_kind("separating_axis"), claim.facts("normal")
        normal = direction(fact(claim, "normal", size))
        gap = lowest(b, normal) - a.highest(normal)
        expect(gap > 0 and gap > dot(normal, velocity), "certificate: the axis does not separate")
        return
    expect(relation == "hit", "truth: relation is wrong")
    claim.answers("relation", "t")
    t = exact_value(claim.truth["t"], "truth.t")
    start = kind == "start"
    expect(start or kind == "first_contact", WRONG_KIND)
    claim.facts(*(["point"] if start else ["point", "normal"]))
    expect(t == 0 if start else 0 < t <= 1, "truth: t is wrong")
    point = fact(claim, "point", size)
    before = [p - t * v for p, v in zip(point, velocity)]
    expect(a.holds(before) and b.holds(point), "certificate: the point is not in both at t")
    if start:
        return
    normal = direction(fact(claim, "normal", size))
    speed = dot(normal, velocity)
    first = speed > 0 and a.highest(normal) + t * speed <= lowest(b, normal)
    expect(first, "certificate: the axis does not separate them before t")
