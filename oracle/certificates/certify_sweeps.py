# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for moving shapes, one function for each operation, as in check_sweeps.cpp."""

from certify_reading import WRONG_KIND, expect
from certify_space import ball, dot, plane, point_in_space, triple
from certify_surd import exact_surd

NO_PROOF = "certificate: the kind does not hold"


def minus(p, q):
    return tuple(x - y for x, y in zip(p, q))


def squared_gap(claim):
    """(C, B, A): |c + t v|^2 - r^2 = C + B t + A t^2 is at most 0 where the balls meet."""
    (p, r), (q, s) = ball(claim.input["a"], "a"), ball(claim.input["b"], "b")
    velocities = [point_in_space(claim.input[name], name) for name in ("velocity_a", "velocity_b")]
    c, v = minus(p, q), minus(*velocities)
    return dot(c, c) - (r + s) ** 2, 2 * dot(c, v), dot(v, v)


def never_zero(kind, constant, linear, square):
    """Why each proves it stands in check_sweeps.cpp."""
    if constant <= 0:
        return False
    if kind == "receding":
        return linear >= 0
    if kind == "too_late":
        return constant + linear + square > 0 and 2 * square + linear <= 0
    expect(kind == "no_root", WRONG_KIND)
    return 4 * square * constant - linear**2 > 0


def prove_first_zero(claim, constant, linear, square):
    relation, kind = claim.word("relation"), claim.kind()
    expect(relation in ("hit", "never"), "truth: relation is wrong")
    claim.facts("polynomial")
    expect(triple(claim, "polynomial") == (constant, linear, square), "certificate: the polynomial is wrong")
    if relation == "never":
        claim.answers("relation")
        expect(never_zero(kind, constant, linear, square), NO_PROOF)
        return
    claim.answers("relation", "t")
    t = exact_surd(claim.truth["t"], "truth.t")
    if kind == "start":
        expect(constant <= 0, NO_PROOF)
        expect(t.sign() == 0, "truth: t is wrong")
        return
    expect(kind == "first_root", WRONG_KIND)
    expect(constant > 0, NO_PROOF)
    zero = (t.square() * square + t * linear + constant).sign() == 0
    first = t.sign() > 0 and (t + -1).sign() <= 0 and zero and (t * (2 * square) + linear).sign() <= 0
    expect(first, "truth: t is wrong")


def check_swept_sphere_sphere(claim):
    claim.inputs("a", "b", "velocity_a", "velocity_b")
    prove_first_zero(claim, *squared_gap(claim))


def check_swept_sphere_plane(claim):
    claim.inputs("sphere", "velocity", "plane")
    center, radius = ball(claim.input["sphere"], "sphere")
    velocity = point_in_space(claim.input["velocity"], "velocity")
    normal, offset = plane(claim.input["plane"], "plane")
    e, rise = dot(normal, center) + offset, dot(normal, velocity)
    prove_first_zero(claim, e * e - radius**2 * dot(normal, normal), 2 * e * rise, rise * rise)
