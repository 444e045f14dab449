# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for steps with moments, as in check_impacts.cpp."""

from fractions import Fraction
from math import isqrt

from certify_bodies import minus, plus, restitution, times
from certify_reading import Claim, expect, number, only
from certify_space import dot, exact_triple
from certify_steps import movers, planes
from certify_surd import Surd, exact_surd

MOST_MOMENTS, MOST_CONTACTS_AT_A_ROOT = 16, 6


def product(x, y):
    """Multiplies numbers over one root, that of the moment's t."""
    r = x.r if x.q != 0 else y.r
    return Surd(x.p * y.p + x.q * y.q * r, x.p * y.q + x.q * y.p, r)


def total(x, y):
    return Surd(x.p + y.p, x.q + y.q, x.r if x.q != 0 else y.r)


def lifted(v):
    return tuple(Surd(x) for x in v)


def scaled(t, v):
    return tuple(product(t, x) for x in v)


def added(v, w):
    return tuple(total(x, y) for x, y in zip(v, w))


def difference(v, w):
    return tuple(total(x, y * -1) for x, y in zip(v, w))


def inner(v, w):
    x, y, z = (product(a, b) for a, b in zip(v, w))
    return total(total(x, y), z)


def is_square(r):
    r = Fraction(r)
    return isqrt(r.numerator) ** 2 == r.numerator and isqrt(r.denominator) ** 2 == r.denominator


def expect_nearest(rounded, exact, what):
    """The nearest number of 53 binary digits: n 2^k with 2^52 <= |n| < 2^53; half of 2^k away at most, or a quarter on
    the side of 0 where n is 2^52; and n is even where it is as far as that."""
    wrong = what + ": not the nearest number of 53 digits"
    if rounded == 0:
        expect(exact.sign() == 0, wrong)
        return
    above, below = abs(rounded.numerator), rounded.denominator
    odd = above >> ((above & -above).bit_length() - 1)
    digits = odd.bit_length()
    expect(below & (below - 1) == 0 and digits <= 53, wrong)
    last = Fraction(1 << (above.bit_length() - 1), below) / (1 << 52)
    even, half = digits < 53, last / 2
    toward_zero = last / 4 if digits == 1 else half
    outwards = exact * (1 if rounded > 0 else -1)
    over, under = (outwards + (-abs(rounded) - half)).sign(), (outwards + (toward_zero - abs(rounded))).sign()
    expect(over < 0 or (over == 0 and even), wrong)
    expect(under > 0 or (under == 0 and even), wrong)


class Step:
    def __init__(self, claim):
        self.claim = claim
        self.bodies = movers(claim.input["bodies"])
        self.walls = planes(claim.input["walls"])
        self.restitution = restitution(claim.input["restitution"], "restitution")
        self.timestep = number(claim.input["timestep"], "timestep")
        expect(self.timestep > 0, "timestep: timestep > 0")
        self.at = [center for _, _, center, _ in self.bodies]
        self.velocities = [v for _, v, _, _ in self.bodies]
        self.clocks = [Fraction(0)] * len(self.bodies)
        self.settled = set()

    def check(self):
        claim = self.claim
        course = claim.word("relation")
        finished, too_many = course == "finished", course == "too_many_contacts"
        expect(finished or too_many or course == "too_many_moments", "truth.relation: no such word")
        claim.answers("relation", "moments", *(["bodies"] if finished else []))
        claim.expect_kind("impacts"), claim.facts("moments")
        moments, proofs = claim.truth["moments"], claim.certificate["moments"]
        expect(isinstance(moments, list) and len(moments) <= MOST_MOMENTS, "truth.moments: a list of at most 16")
        expect(isinstance(proofs, list) and len(proofs) + too_many == len(moments),
               "certificate.moments: one for each that is answered")
        for k, moment in enumerate(moments):
            name = f"truth.moments[{k}]"
            only(moment, name, ["t", "contacts"])
            t = exact_surd(moment["t"], name + ".t")
            expect((t + -1).sign() <= 0, name + ".t: at most 1")
            contacts = self.contacts_of(t, name)
            listed = moment["contacts"]
            same = isinstance(listed, list) and len(listed) == len(contacts) and all(
                isinstance(pair, list) and all(type(place) is int for place in pair) and pair == list(contact[0])
                for pair, contact in zip(listed, contacts))
            expect(same, name + ".contacts: not those of this moment")
            beyond = self.has_too_many(t, contacts)
            expect(beyond == (too_many and k + 1 == len(moments)), "truth.relation: not what the contacts say")
            if not beyond:
                self.answer(proofs[k], t, contacts, name)
        if finished:
            self.expect_end()
        elif not too_many:
            expect(len(moments) == MOST_MOMENTS and self.another(), "truth.relation: there are no more moments")

    def is_wall(self, place):
        return place >= len(self.bodies)

    def moves(self, place):
        return not self.is_wall(place) and self.bodies[place][0] != 0

    def pairs(self):
        return [(i, j) for i in range(len(self.bodies)) for j in range(i + 1, len(self.bodies) + len(self.walls))
                if self.moves(i) or self.moves(j)]

    def start_of(self, pair):
        return max(self.clocks[place] for place in pair if not self.is_wall(place))

    def place_at(self, body, t):
        passed = (t + -self.clocks[body]) * self.timestep
        return added(lifted(self.at[body]), scaled(passed, lifted(self.velocities[body])))

    def normal_at(self, pair, t):
        if self.is_wall(pair[1]):
            return lifted(self.walls[pair[1] - len(self.bodies)][0])
        return difference(self.place_at(pair[0], t), self.place_at(pair[1], t))

    def relative_velocity(self, pair):
        v = self.velocities[pair[0]]
        return v if self.is_wall(pair[1]) else minus(v, self.velocities[pair[1]])

    def parting_at(self, pair, t):
        return inner(self.normal_at(pair, t), lifted(self.relative_velocity(pair)))

    def gap_at(self, pair, t):
        """The sign of how far they are from touching."""
        n, radius = self.normal_at(pair, t), self.bodies[pair[0]][3]
        if not self.is_wall(pair[1]):
            reach = radius + self.bodies[pair[1]][3]
            return (inner(n, n) + -(reach**2)).sign()
        height = inner(n, self.place_at(pair[0], t)) + self.walls[pair[1] - len(self.bodies)][1]
        if height.sign() < 0:
            return -1
        return total(height.square(), inner(n, n) * -(radius**2)).sign()

    def collides_until(self, pair, t, counts):
        """Returns whether the pair collides before t, or at t as well if it `counts`."""
        start = self.start_of(pair)
        begin = Surd(start)
        wait = (t + -start).sign()
        if wait < 0 or (wait == 0 and not counts) or self.parting_at(pair, begin).sign() >= 0:
            return False
        if self.gap_at(pair, begin) <= 0:
            return True
        gap = self.gap_at(pair, t)
        if self.is_wall(pair[1]):
            return gap <= 0 if counts else gap < 0
        apart, v = tuple(x.p for x in self.normal_at(pair, begin)), self.relative_velocity(pair)
        reach = self.bodies[pair[0]][3] + self.bodies[pair[1]][3]
        if dot(apart, v) ** 2 - dot(v, v) * (dot(apart, apart) - reach**2) <= 0:
            return False
        return gap < 0 or (counts and gap == 0) or self.parting_at(pair, t).sign() > 0

    def another(self):
        """Returns whether a pair collides in what is left of the step."""
        return any(pair not in self.settled and self.collides_until(pair, Surd(Fraction(1)), True)
                   for pair in self.pairs())

    def contacts_of(self, t, name):
        """[[places, normal, how fast they part, whether they collide, group]]"""
        met = []
        for pair in self.pairs():
            settled = pair in self.settled
            expect(settled or not self.collides_until(pair, t, False), name + ".t: a pair collides before")
            if (t + -self.start_of(pair)).sign() < 0 or self.gap_at(pair, t) > 0:
                continue
            n, parting = self.normal_at(pair, t), self.parting_at(pair, t)
            if inner(n, n).sign() == 0 or parting.sign() > 0:
                continue
            group = len(met)
            joined = {c[4] for c in met if any(self.moves(place) and place in pair for place in c[0])}
            for c in met:
                if c[4] in joined:
                    c[4] = group
            met.append([pair, n, parting, parting.sign() < 0 and not settled, group])
        colliding = {c[4] for c in met if c[3]}
        met = [c for c in met if c[4] in colliding]
        expect(met, name + ".t: nothing collides then")
        return met

    @staticmethod
    def has_too_many(t, contacts):
        groups = [c[4] for c in contacts]
        return t.q != 0 and not is_square(t.r) and max(map(groups.count, groups)) > MOST_CONTACTS_AT_A_ROOT

    def answer(self, certificate, t, contacts, name):
        """The conditions of Karush, Kuhn and Tucker, as for simulation_step, and what is kept of the numbers."""
        proof = Claim({"input": self.claim.input, "truth": self.claim.truth, "certificate": certificate})
        proof.expect_kind("pushes"), proof.facts("impulses", "impulses_of_root", "clock", "states")
        rational, of_root, states = proof.list("impulses"), proof.list("impulses_of_root"), proof.list("states")
        clock = proof.single("clock")
        expect(len(rational) == len(contacts) and len(of_root) == len(contacts),
               "certificate.impulses: one for each contact")
        after, impulses = {}, [Surd(p, q, t.r) for p, q in zip(rational, of_root)]
        for impulse, ((i, j), normal, *_) in zip(impulses, contacts):
            expect(impulse.sign() >= 0, "certificate.impulses: not negative")
            for body, side in ((i, 1), (j, -1)):
                if self.moves(body):
                    v = after.get(body, lifted(self.velocities[body]))
                    after[body] = added(v, scaled(impulse * (side * self.bodies[body][0]), normal))
        still = lifted((Fraction(0),) * 3)
        for k, (impulse, ((i, j), normal, before, *_)) in enumerate(zip(impulses, contacts)):
            parting = inner(normal, difference(after.get(i, still), after.get(j, still)))
            surplus = total(parting, before * self.restitution).sign()
            expect(surplus >= 0, f"{name}.contacts[{k}]: its demand is broken")
            expect(impulse.sign() == 0 or surplus == 0, f"{name}.contacts[{k}]: pushes beyond its demand")
        expect_nearest(clock, t, "certificate.clock")
        expect(len(states) == 6 * len(after), "certificate.states: six numbers for each body")
        self.settled = {pair for pair in self.settled if pair[0] not in after and pair[1] not in after}
        self.settled |= {c[0] for c in contacts}
        for n, body in enumerate(sorted(after)):
            for k, exact in enumerate((*self.place_at(body, t), *after[body])):
                expect_nearest(states[6 * n + k], exact, f"certificate.states[{6 * n + k}]")
            self.at[body] = tuple(states[6 * n:6 * n + 3])
            self.velocities[body] = tuple(states[6 * n + 3:6 * n + 6])
            self.clocks[body] = clock

    def expect_end(self):
        expect(not self.another(), "truth.moments: a pair collides after the last")
        states = self.claim.truth["bodies"]
        expect(isinstance(states, list) and len(states) == len(self.bodies), "truth.bodies: one for each body")
        for i, state in enumerate(states):
            name = f"truth.bodies[{i}]"
            only(state, name, ["position", "velocity"])
            end = plus(self.at[i], times((1 - self.clocks[i]) * self.timestep, self.velocities[i]))
            expect(exact_triple(state["position"], name + ".position") == end,
                   name + ".position: not where it comes to")
            expect(exact_triple(state["velocity"], name + ".velocity") == self.velocities[i],
                   name + ".velocity: not what impulses make")


def check_impact_step(claim):
    claim.inputs("bodies", "walls", "restitution", "timestep")
    Step(claim).check()
