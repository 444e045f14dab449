# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for steps, as in check_steps.cpp."""

from fractions import Fraction

from certify_bodies import minus, plus, restitution, times
from certify_reading import expect, number, only
from certify_space import ball, dot, exact_triple, plane, point_in_space

NOTHING = (0, 0, 0)


def movers(value):
    """[(inverse mass, velocity, center, radius)]"""
    expect(isinstance(value, list), "bodies: a list")
    found = []
    for i, body in enumerate(value):
        name = f"bodies[{i}]"
        only(body, name, ["inverse_mass", "velocity", "sphere"])
        w = number(body["inverse_mass"], name + ".inverse_mass")
        v = point_in_space(body["velocity"], name + ".velocity")
        expect(w >= 0, name + ".inverse_mass: inverse mass >= 0")
        expect(w != 0 or v == NOTHING, name + ".velocity: 0 where the inverse mass is 0")
        found.append((w, v, *ball(body["sphere"], name + ".sphere")))
    return found


def planes(value):
    expect(isinstance(value, list), "walls: a list")
    return [plane(wall, f"walls[{i}]") for i, wall in enumerate(value)]


def choice(value, what, words):
    expect(isinstance(value, str) and value in words, what + ": no such word")
    return value


class Settings:
    def __init__(self, value):
        only(value, "settings", ["gravity", "motion", "restitution", "timestep", "turn"])
        gravity = point_in_space(value["gravity"], "settings.gravity")
        motions = ["accelerate_then_move", "move_then_accelerate", "parabola"]
        self.motion = choice(value["motion"], "settings.motion", motions)
        self.before_move = choice(value["turn"], "settings.turn", ["before_move", "after_move"]) == "before_move"
        self.restitution = restitution(value["restitution"], "settings.restitution")
        self.timestep = number(value["timestep"], "settings.timestep")
        expect(self.timestep > 0, "settings.timestep: timestep > 0")
        self.fall = times(self.timestep, gravity)  # what gravity adds to a velocity in a step

    def accelerated(self, bodies, velocities):
        return [plus(v, self.fall) if body[0] != 0 else v for body, v in zip(bodies, velocities)]

    def ends(self, bodies, velocities):
        found = []
        for (w, _, center, _), v in zip(bodies, velocities):
            mean = plus(v, times(Fraction(1, 2), self.fall)) if self.motion == "parabola" else v
            found.append(plus(center, times(self.timestep, mean)) if w != 0 else center)
        return found


def contacts_at(ends, bodies, velocities, walls):
    """[(body, other, normal, how fast they part)]: all contacts at these ends, in ascending order. With a wall the
    other is beyond the bodies."""
    found = []

    def take(i, j, normal, relative):
        parting = dot(normal, relative)
        if parting <= 0:
            found.append((i, j, normal, parting))

    for i, (w, _, _, radius) in enumerate(bodies):
        for j in range(i + 1, len(bodies)):
            apart, reach = minus(ends[i], ends[j]), radius + bodies[j][3]
            if dot(apart, apart) <= reach**2 and apart != NOTHING and (w != 0 or bodies[j][0] != 0):
                take(i, j, apart, minus(velocities[i], velocities[j]))
        for k, (normal, offset) in enumerate(walls):
            height = dot(normal, ends[i]) + offset
            if w != 0 and (height <= 0 or height**2 <= radius**2 * dot(normal, normal)):
                take(i, len(bodies) + k, normal, velocities[i])
    return found


def expect_listed(claim, contacts):
    listed, reason = claim.truth["contacts"], "truth.contacts: not those of this step"
    expect(isinstance(listed, list) and len(listed) == len(contacts), reason)
    for pair, (i, j, _, _) in zip(listed, contacts):
        whole = isinstance(pair, list) and all(type(place) is int for place in pair)
        expect(whole and pair == [i, j], reason)


def pushed(claim, contacts, bodies, velocities, e):
    """The velocities after."""
    impulses, after = claim.list("impulses"), list(velocities)
    expect(len(impulses) == len(contacts), "certificate.impulses: one for each contact")
    for impulse, (i, j, normal, _) in zip(impulses, contacts):
        expect(impulse >= 0, "certificate.impulses: not negative")
        after[i] = plus(after[i], times(bodies[i][0] * impulse, normal))
        if j < len(bodies):
            after[j] = minus(after[j], times(bodies[j][0] * impulse, normal))
    for k, (impulse, (i, j, normal, before)) in enumerate(zip(impulses, contacts)):
        parting = dot(normal, minus(after[i], after[j]) if j < len(bodies) else after[i])
        expect(parting >= -e * before, f"truth.contacts[{k}]: its demand is broken")
        expect(impulse == 0 or parting == -e * before, f"truth.contacts[{k}]: pushes beyond its demand")
    return after


def check_simulation_step(claim):
    claim.inputs("bodies", "walls", "settings")
    bodies, walls = movers(claim.input["bodies"]), planes(claim.input["walls"])
    settings = Settings(claim.input["settings"])
    falls_first = settings.motion == "accelerate_then_move"
    claim.answers("contacts", "bodies")
    claim.expect_kind("pushes"), claim.facts("impulses")
    velocities = [v for _, v, _, _ in bodies]
    if falls_first:
        velocities = settings.accelerated(bodies, velocities)
    ends = settings.ends(bodies, velocities)
    if not falls_first and not settings.before_move:
        velocities = settings.accelerated(bodies, velocities)
    contacts = contacts_at(ends, bodies, velocities, walls)
    expect_listed(claim, contacts)
    velocities = pushed(claim, contacts, bodies, velocities, settings.restitution)
    if settings.before_move:
        ends = settings.ends(bodies, velocities)
        velocities = velocities if falls_first else settings.accelerated(bodies, velocities)
    states = claim.truth["bodies"]
    expect(isinstance(states, list) and len(states) == len(bodies), "truth.bodies: one for each body")
    for i, (state, end, v) in enumerate(zip(states, ends, velocities)):
        name = f"truth.bodies[{i}]"
        only(state, name, ["position", "velocity"])
        expect(exact_triple(state["position"], name + ".position") == end, name + ".position: not where it comes to")
        expect(exact_triple(state["velocity"], name + ".velocity") == v, name + ".velocity: not what impulses make")
