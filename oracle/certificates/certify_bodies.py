# SPDX-License-Identifier: Apache-2.0
"""How certify.py reads bodies and what they do, as check_bodies.cpp does."""

from certify_reading import expect, list_of_two, number, only
from certify_space import cross, dot, list_of_three, minus, point_in_space


def plus(p, q):
    return tuple(x + y for x, y in zip(p, q))


def times(t, p):
    return tuple(t * x for x in p)


def bodies(value, what):
    """[(mass, velocity)]"""
    expect(isinstance(value, list), what + ": a list")
    found = []
    for i, body in enumerate(value):
        name = f"{what}[{i}]"
        only(body, name, ["mass", "velocity"])
        mass, velocity = number(body["mass"], name + ".mass"), point_in_space(body["velocity"], name + ".velocity")
        expect(mass > 0, name + ".mass: mass > 0")
        found.append((mass, velocity))
    return found


def moving_body(value, what):
    """(position, velocity, angular velocity)"""
    names = ["position", "velocity", "angular_velocity"]
    only(value, what, names)
    return tuple(point_in_space(value[name], f"{what}.{name}") for name in names)


def rigid_body(value, what):
    """(mass, rows of the inertia, (position, velocity, angular velocity))"""
    only(value, what, ["mass", "inertia", "position", "velocity", "angular_velocity"])
    mass, name = number(value["mass"], what + ".mass"), what + ".inertia"
    rows = [point_in_space(row, f"{name}[{i}]") for i, row in enumerate(list_of_three(value["inertia"], name))]
    names = ("position", "velocity", "angular_velocity")
    motion = tuple(point_in_space(value[part], f"{what}.{part}") for part in names)
    for i, j in ((1, 0), (2, 0), (2, 1)):
        expect(rows[i][j] == rows[j][i], f"{name}[{i}][{j}]: symmetric")
    expect(mass > 0, what + ".mass: mass > 0")
    minor = cross(rows[0], rows[1])
    expect(rows[0][0] > 0 and minor[2] > 0 and dot(minor, rows[2]) > 0, name + ": positive definite")
    return mass, rows, motion


def velocity_at(body, point):
    position, velocity, turn = body
    return plus(velocity, cross(turn, minus(point, position)))


def normal(value, what):
    n = point_in_space(value, what)
    expect(n != (0, 0, 0), what + ": nonzero normal")
    return n


def restitution(value, what):
    e = number(value, what)
    expect(0 <= e <= 1, what + ": between 0 and 1")
    return e


def two_bodies(claim):
    """`masses` and `velocities` of a claim as [(mass, velocity)]."""
    masses = [number(m, f"masses[{i}]") for i, m in enumerate(list_of_two(claim.input["masses"], "masses"))]
    for i, mass in enumerate(masses):
        expect(mass > 0, f"masses[{i}]: mass > 0")
    given = list_of_two(claim.input["velocities"], "velocities")
    return [(mass, point_in_space(v, f"velocities[{i}]")) for i, (mass, v) in enumerate(zip(masses, given))]
