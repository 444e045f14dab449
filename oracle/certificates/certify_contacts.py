# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for bodies in several contacts, as in check_contacts.cpp."""

from certify_bodies import minus, normal, restitution
from certify_reading import expect, number, only
from certify_space import dot, exact_triple, point_in_space
from certify_sums import over_one, times, total


def point_bodies(value):
    """[(inverse mass, velocity)]"""
    expect(isinstance(value, list), "bodies: a list")
    found = []
    for i, body in enumerate(value):
        name = f"bodies[{i}]"
        only(body, name, ["inverse_mass", "velocity"])
        w = number(body["inverse_mass"], name + ".inverse_mass")
        found.append((w, point_in_space(body["velocity"], name + ".velocity")))
        expect(w >= 0, name + ".inverse_mass: inverse mass >= 0")
    return found


def place(value, what, bodies):
    there = isinstance(value, int) and not isinstance(value, bool) and 0 <= value < bodies
    expect(there, what + ": index of a body")
    return value


def contacts_of(value, bodies):
    """[(a, b, normal)]"""
    expect(isinstance(value, list), "contacts: a list")
    found = []
    for i, contact in enumerate(value):
        name = f"contacts[{i}]"
        only(contact, name, ["a", "b", "normal"])
        a, b = (place(contact[end], f"{name}.{end}", len(bodies)) for end in "ab")
        expect(a != b, name + ".b: another body than a")
        found.append((a, b, normal(contact["normal"], name + ".normal")))
    return found


def pushes(claim, name, contacts):
    found = claim.list(name)
    expect(len(found) == len(contacts), f"certificate.{name}: one for each contact")
    expect(all(push >= 0 for push in found), f"certificate.{name}: not negative")
    return found


def sums(contacts, found, bodies):
    """For each body what pushes it in all, as (vector, denominator)."""
    terms = [[((0, 0, 0), 1)] for _ in bodies]
    for (a, b, n), push in zip(contacts, found):
        for body, sign in ((a, 1), (b, -1)):
            terms[body].append(times(sign * push, n))
    return [total(of_body) for of_body in terms]


def expect_velocities(claim, bodies, contacts, demands):
    claim.answers("relation", "velocities")
    claim.expect_kind("pushes"), claim.facts("impulses")
    truth = claim.truth["velocities"]
    expect(isinstance(truth, list) and len(truth) == len(bodies), "truth.velocities: one for each body")
    after = [exact_triple(v, f"truth.velocities[{i}]") for i, v in enumerate(truth)]
    impulses = pushes(claim, "impulses", contacts)
    for i, ((w, v), (push, d)) in enumerate(zip(bodies, sums(contacts, impulses, bodies))):
        change, whole = over_one(minus(after[i], v))
        made = all(x * d == w * y * whole for x, y in zip(change, push))
        expect(made, f"truth.velocities[{i}]: not what the impulses make")
    scaled = [over_one(v) for v in after]
    for i, ((a, b, n), demand) in enumerate(zip(contacts, demands)):
        (va, c), (vb, d) = scaled[a], scaled[b]
        parting, asked = dot(n, va) * d - dot(n, vb) * c, demand * c * d
        expect(parting >= asked, f"contacts[{i}]: its demand is broken")
        expect(impulses[i] == 0 or parting == asked, f"contacts[{i}]: pushes beyond its demand")


def expect_contradiction(claim, bodies, contacts, demands):
    claim.answers("relation")
    claim.expect_kind("contradiction"), claim.facts("weights")
    weights = pushes(claim, "weights", contacts)
    terms = [times(weight, (demand,)) for weight, demand in zip(weights, demands)]
    for i, ((w, v), (push, d)) in enumerate(zip(bodies, sums(contacts, weights, bodies))):
        if w == 0:
            terms.append(((-dot(push, v),), d))
        else:
            expect(push == (0, 0, 0), f"bodies[{i}]: the weights do not cancel")
    (left,), _ = total(terms or [((0,), 1)])
    expect(left > 0, "certificate: the demands do not contradict each other")


def check_simultaneous_collisions(claim):
    claim.inputs("bodies", "contacts", "e")
    bodies = point_bodies(claim.input["bodies"])
    contacts = contacts_of(claim.input["contacts"], bodies)
    e = restitution(claim.input["e"], "e")
    demands = [e * max(0, -dot(n, minus(bodies[a][1], bodies[b][1]))) for a, b, n in contacts]
    relation = claim.word("relation")
    expect(relation in ("possible", "impossible"), "truth: relation is wrong")
    (expect_velocities if relation == "possible" else expect_contradiction)(claim, bodies, contacts, demands)
