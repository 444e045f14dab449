# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for collision response, one function for each operation, as in check_response.cpp."""

from certify_bodies import (bodies, minus, moving_body, normal, plus, restitution, rigid_body, times,
                            two_bodies, velocity_at)
from certify_reading import exact_value, expect, list_of_two, number, only
from certify_space import cross, dot, exact_triple, plane, point_in_space, triple


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


def check_inelastic_collision(claim):
    claim.inputs("masses", "velocities")
    (m1, v1), (m2, v2) = two_bodies(claim)
    claim.answers("velocity")
    claim.expect_kind("momentum"), claim.facts("momentum")
    after, momentum = exact_triple(claim.truth["velocity"], "truth.velocity"), triple(claim, "momentum")
    expect(momentum == plus(times(m1, v1), times(m2, v2)), "certificate: the momentum is wrong")
    expect(times(m1 + m2, after) == momentum, "truth: momentum is not kept")


def expect_impulse(claim, before, n, e):
    (m1, v1), (m2, v2) = before
    claim.answers("velocities")
    claim.expect_kind("impulse"), claim.facts("impulse", "doubled_energies")
    truth = list_of_two(claim.truth["velocities"], "truth.velocities")
    v, w = (exact_triple(velocity, f"truth.velocities[{i}]") for i, velocity in enumerate(truth))
    impulse, energies = claim.single("impulse"), claim.pair("doubled_energies")
    expect(times(m1, minus(v, v1)) == times(impulse, n), "truth: the first body's impulse is another")
    expect(times(m2, minus(w, v2)) == times(-impulse, n), "truth: momentum is not kept")
    expect(dot(minus(v, w), n) == -e * dot(minus(v1, v2), n), "truth: the relative velocity along the normal is wrong")
    recomputed = (m1 * dot(v1, v1) + m2 * dot(v2, v2), m1 * dot(v, v) + m2 * dot(w, w))
    expect(energies == recomputed, "certificate: the energies are wrong")
    kept = energies[1] == energies[0] if e == 1 else energies[1] <= energies[0]
    expect(kept, "truth: energy is gained or lost")


def check_elastic_collision(claim):
    claim.inputs("masses", "velocities", "normal")
    before = two_bodies(claim)
    expect_impulse(claim, before, normal(claim.input["normal"], "normal"), 1)


def check_restitution_collision(claim):
    claim.inputs("masses", "velocities", "normal", "e")
    before, n = two_bodies(claim), normal(claim.input["normal"], "normal")
    expect_impulse(claim, before, n, restitution(claim.input["e"], "e"))


def check_penalty_force(claim):
    claim.inputs("point", "velocity", "plane", "stiffness", "damping")
    p, v = point_in_space(claim.input["point"], "point"), point_in_space(claim.input["velocity"], "velocity")
    n, offset = plane(claim.input["plane"], "plane")
    k, c = number(claim.input["stiffness"], "stiffness"), number(claim.input["damping"], "damping")
    claim.answers("force")
    force = exact_triple(claim.truth["force"], "truth.force")
    if dot(n, p) + offset >= 0:
        claim.expect_kind("no_contact"), claim.facts()
        expect(force == (0, 0, 0), "truth: force is wrong")
        return
    claim.expect_kind("foot"), claim.facts("foot", "along")
    foot, u = triple(claim, "foot"), triple(claim, "along")
    expect(dot(n, foot) + offset == 0, "certificate: the foot is not on the plane")
    expect(cross(minus(foot, p), n) == (0, 0, 0), "certificate: the foot is another point's")
    expect(cross(u, n) == (0, 0, 0), "certificate: along is not along the normal")
    expect(dot(minus(v, u), n) == 0, "certificate: along is not all of it")
    expect(force == minus(times(k, minus(foot, p)), times(c, u)), "truth: force is wrong")


def check_contact_state(claim):
    claim.inputs("a", "b", "point", "normal")
    a, b = moving_body(claim.input["a"], "a"), moving_body(claim.input["b"], "b")
    p, n = point_in_space(claim.input["point"], "point"), normal(claim.input["normal"], "normal")
    claim.answers("state")
    claim.expect_kind("point_velocities"), claim.facts("of_a", "of_b")
    of_a, of_b = triple(claim, "of_a"), triple(claim, "of_b")
    expect(of_a == velocity_at(a, p), "certificate: of_a is wrong")
    expect(of_b == velocity_at(b, p), "certificate: of_b is wrong")
    apart = dot(minus(of_a, of_b), n)
    state = "separating" if apart > 0 else "colliding" if apart < 0 else "resting"
    expect(claim.word("state") == state, "truth: state is wrong")


def check_rigid_body_collision(claim):
    claim.inputs("a", "b", "point", "normal", "e")
    a, b = rigid_body(claim.input["a"], "a"), rigid_body(claim.input["b"], "b")
    p, n = point_in_space(claim.input["point"], "point"), normal(claim.input["normal"], "normal")
    e = restitution(claim.input["e"], "e")
    claim.answers("a", "b")
    claim.expect_kind("impulse_at"), claim.facts("impulse", "doubled_energies")
    impulse, energies = claim.single("impulse"), claim.pair("doubled_energies")
    before = after = 0
    apart = []
    for name, (mass, inertia, motion), push in (("a", a, times(impulse, n)), ("b", b, times(-impulse, n))):
        truth, (position, velocity, turn) = claim.truth[name], motion
        only(truth, "truth." + name, ["velocity", "angular_velocity"])
        v, w = (exact_triple(truth[part], f"truth.{name}.{part}") for part in ("velocity", "angular_velocity"))
        turned = tuple(dot(row, minus(w, turn)) for row in inertia)
        expect(times(mass, minus(v, velocity)) == push, f"truth: momentum of {name} is wrong")
        expect(turned == cross(minus(p, position), push), f"truth: angular momentum of {name} is wrong")
        before += mass * dot(velocity, velocity) + dot(turn, tuple(dot(row, turn) for row in inertia))
        after += mass * dot(v, v) + dot(w, tuple(dot(row, w) for row in inertia))
        apart.append((dot(velocity_at(motion, p), n), dot(velocity_at((position, v, w), p), n)))
    (a_before, a_after), (b_before, b_after) = apart
    expect(a_after - b_after == -e * (a_before - b_before), "truth: the relative velocity along the normal is wrong")
    expect(energies == (before, after), "certificate: the energies are wrong")
    expect(after == before if e == 1 else after <= before, "truth: energy is gained or lost")


def check_momentum(claim):
    claim.inputs("bodies")
    total = (0, 0, 0)
    for mass, velocity in bodies(claim.input["bodies"], "bodies"):
        total = plus(total, times(mass, velocity))
    claim.answers("momentum")
    claim.expect_kind("sum"), claim.facts()
    expect(exact_triple(claim.truth["momentum"], "truth.momentum") == total, "truth: momentum is wrong")


def check_kinetic_energy(claim):
    claim.inputs("bodies")
    every = bodies(claim.input["bodies"], "bodies")
    claim.answers("energy")
    claim.expect_kind("centre"), claim.facts("mass", "velocity", "doubled_energies")
    energy, mass = exact_value(claim.truth["energy"], "truth.energy"), claim.single("mass")
    centre, parts = triple(claim, "velocity"), claim.pair("doubled_energies")
    expect(mass == sum(m for m, _ in every), "certificate: the mass is wrong")
    momentum = tuple(sum(m * v[axis] for m, v in every) for axis in range(3))
    right = times(mass, centre) == momentum and (mass > 0 or centre == (0, 0, 0))
    expect(right, "certificate: the velocity of the centre is wrong")
    seen = sum(m * dot(minus(v, centre), minus(v, centre)) for m, v in every)
    expect(parts == (mass * dot(centre, centre), seen), "certificate: the energies are wrong")
    doubled = sum(m * dot(v, v) for m, v in every)
    expect(2 * energy == doubled == parts[0] + parts[1], "truth: energy is wrong")
