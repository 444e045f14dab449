# SPDX-License-Identifier: Apache-2.0
"""The second truths of collision response, for simplest_truth.py: each takes an input as it stands in a claim and
gives the answer and the margin."""
from fractions import Fraction
from itertools import combinations

from simplest_truth_reading import dot, minus, number, point

WITHOUT = {
    "impact_step": "its moments are irrational; certify_impacts.py decides each again by signs of fractions",
}


def truth_reflect_wall(q):
    """Nothing is decided: there is no margin."""
    turned = {q["axis"]: -1}
    return {"velocity": [str(turned.get(axis, 1) * number(v)) for axis, v in zip("xyz", q["velocity"])]}, None


def written_velocity(v):
    return [str(x) for x in v]


def without_part(v, n, share):
    """v less so many times its part along n."""
    return tuple(x - share * dot(v, n) / dot(n, n) * y for x, y in zip(v, n))


def truth_reflect_plane(q):
    return {"velocity": written_velocity(without_part(point(q["velocity"]), point(q["normal"]), 2))}, None


def truth_damped_reflection(q):
    share = 1 + number(q["k"])
    return {"velocity": written_velocity(without_part(point(q["velocity"]), point(q["normal"]), share))}, None


def truth_inelastic_collision(q):
    (m1, m2), (v1, v2) = map(number, q["masses"]), map(point, q["velocities"])
    return {"velocity": written_velocity((m1 * x + m2 * y) / (m1 + m2) for x, y in zip(v1, v2))}, None


def after_impact(q, e):
    """In the frame in which the bodies have no momentum together, each one's part along the normal is turned round and
    multiplied by e."""
    (m1, m2), velocities = map(number, q["masses"]), list(map(point, q["velocities"]))
    centre = [(m1 * x + m2 * y) / (m1 + m2) for x, y in zip(*velocities)]
    turned = (without_part(minus(v, centre), point(q["normal"]), 1 + e) for v in velocities)
    return {"velocities": [written_velocity(x + c for x, c in zip(v, centre)) for v in turned]}, None


def truth_elastic_collision(q):
    return after_impact(q, 1)


def truth_restitution_collision(q):
    return after_impact(q, number(q["e"]))


def truth_penalty_force(q):
    p, v, n = point(q["point"]), point(q["velocity"]), point(q["plane"]["normal"])
    height = dot(n, p) + number(q["plane"]["offset"])
    pull = number(q["stiffness"]) * height + number(q["damping"]) * dot(n, v) if height < 0 else 0
    return {"force": written_velocity(-pull * x / dot(n, n) for x in n)}, height**2 / dot(n, n)


def determinant(u, v, w):
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
            u[2] * (v[0] * w[1] - v[1] * w[0]))


def truth_contact_state(q):
    """By determinants: n . (w x r) is that of n, w and r."""
    n, p, apart = point(q["normal"]), point(q["point"]), Fraction(0)
    for body, sign in ((q["a"], 1), (q["b"], -1)):
        arm = minus(p, point(body["position"]))
        apart += sign * (dot(n, point(body["velocity"])) + determinant(n, point(body["angular_velocity"]), arm))
    state = "separating" if apart > 0 else "colliding" if apart < 0 else "resting"
    return {"state": state}, apart**2 / dot(n, n)


def crossed(v, w):
    return tuple(v[i - 2] * w[i - 1] - v[i - 1] * w[i - 2] for i in range(3))


def truth_rigid_body_collision(q):
    """The law of p. 74, with Cramer's rule for what an impulse turns."""
    n, p, apart, resistance, bodies = point(q["normal"]), point(q["point"]), 0, 0, []
    for body, sign in ((q["a"], 1), (q["b"], -1)):
        mass, rows = number(body["mass"]), [point(row) for row in body["inertia"]]
        v, w, arm = point(body["velocity"]), point(body["angular_velocity"]), minus(p, point(body["position"]))
        moment = crossed(arm, n)
        turn = tuple(determinant(*(rows[:i] + [moment] + rows[i + 1:])) / determinant(*rows) for i in range(3))
        apart += sign * (dot(n, v) + dot(w, moment))
        resistance += dot(n, n) / mass + dot(moment, turn)
        bodies.append((mass, v, w, turn, sign))
    j = -(1 + number(q["e"])) * apart / resistance
    return {name: {"velocity": written_velocity(x + sign * j / mass * y for x, y in zip(v, n)),
                   "angular_velocity": written_velocity(x + sign * j * y for x, y in zip(w, turn))}
            for name, (mass, v, w, turn, sign) in zip("ab", bodies)}, None


def truth_momentum(q):
    bodies = [(number(body["mass"]), point(body["velocity"])) for body in q["bodies"]]
    return {"momentum": [str(sum(m * v[axis] for m, v in bodies)) for axis in range(3)]}, None


def truth_kinetic_energy(q):
    bodies = [(number(body["mass"]), point(body["velocity"])) for body in q["bodies"]]
    return {"energy": str(sum((m * dot(v, v) for m, v in bodies), Fraction(0)) / 2)}, None


def solved(matrix, right):
    """By elimination; None where the matrix is singular."""
    rows = [list(row) + [b] for row, b in zip(matrix, right)]
    for k in range(len(rows)):
        pivot = next((i for i in range(k, len(rows)) if rows[i][k] != 0), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(len(rows)):
            if i != k:
                share = rows[i][k] / rows[k][k]
                rows[i] = [x - share * y for x, y in zip(rows[i], rows[k])]
    return [row[-1] / row[k] for k, row in enumerate(rows)]


def resolved(bodies, contacts, e):
    """The velocities after, of bodies (inverse mass, velocity) in contacts (a, b, normal); None where the contacts
    contradict each other. All sets of contacts that may push, the smallest first, until one neither pulls nor breaks a
    demand."""
    weights = []  # of a contact's impulse in the velocities: {body: vector}
    for a, b, n in contacts:
        weights.append({a: [bodies[a][0] * x for x in n], b: [-bodies[b][0] * x for x in n]})
    zero = (0, 0, 0)
    matrix = [[dot(n, minus(w.get(a, zero), w.get(b, zero))) for w in weights] for a, b, n in contacts]
    parting = [dot(n, minus(bodies[a][1], bodies[b][1])) for a, b, n in contacts]
    wanted = [-(1 + e) * g if g < 0 else -g for g in parting]
    places = range(len(contacts))
    for size in range(len(contacts) + 1):
        for pushing in combinations(places, size):
            found = solved([[matrix[i][j] for j in pushing] for i in pushing], [wanted[i] for i in pushing])
            if found is None or any(x < 0 for x in found):
                continue
            if any(sum(matrix[i][j] * x for j, x in zip(pushing, found)) < wanted[i] for i in places):
                continue
            after = [list(v) for _, v in bodies]
            for j, x in zip(pushing, found):
                for body, vector in weights[j].items():
                    after[body] = [v + x * y for v, y in zip(after[body], vector)]
            return after
    return None


def truth_simultaneous_collisions(q):
    bodies = [(number(body["inverse_mass"]), point(body["velocity"])) for body in q["bodies"]]
    contacts = [(c["a"], c["b"], point(c["normal"])) for c in q["contacts"]]
    after = resolved(bodies, contacts, number(q["e"]))
    if after is None:
        return {"relation": "impossible"}, None
    return {"relation": "possible", "velocities": [written_velocity(v) for v in after]}, None


def truth_simulation_step(q):
    """Walls are bodies of a kind, each one of its own: they have no center, but a normal and a distance."""
    settings = q["settings"]
    h, pull = number(settings["timestep"]), point(settings["gravity"])
    before, motion = settings["turn"] == "before_move", settings["motion"]
    share = {"accelerate_then_move": 1, "parabola": Fraction(1, 2), "move_then_accelerate": 0}[motion]
    movers = [(number(b["inverse_mass"]), point(b["velocity"]), point(b["sphere"]["center"]),
               number(b["sphere"]["radius"])) for b in q["bodies"]]
    walls = [(point(w["normal"]), number(w["offset"])) for w in q["walls"]]
    moves = [w != 0 for w, _, _, _ in movers]
    gravity = [tuple(h * x for x in pull) if moving else (0, 0, 0) for moving in moves]
    ends = [tuple(x + h * (y + share * g) for x, y, g in zip(c, v, fall))
            for (_, v, c, _), fall in zip(movers, gravity)]
    early = motion == "accelerate_then_move" or not before  # gravity comes before the response
    bodies = [(w, tuple(x + early * g for x, g in zip(v, fall))) for (w, v, _, _), fall in zip(movers, gravity)]
    bodies += [(Fraction(0), (0, 0, 0))] * len(walls)
    contacts = []
    for i, j in combinations(range(len(bodies)), 2):
        if i >= len(movers) or not (moves[i] or (j < len(movers) and moves[j])):
            continue
        if j < len(movers):
            n, reach = minus(ends[i], ends[j]), movers[i][3] + movers[j][3]
            meet = 0 < dot(n, n) <= reach * reach
        else:
            n, offset = walls[j - len(movers)]
            height = dot(n, ends[i]) + offset
            meet = height <= 0 or height * height <= movers[i][3] ** 2 * dot(n, n)
        if meet and dot(n, minus(bodies[i][1], bodies[j][1])) <= 0:
            contacts.append((i, j, n))
    after = resolved(bodies, contacts, number(settings["restitution"]))
    states = []
    for (_, _, center, _), end, v, moving, fall in zip(movers, ends, after, moves, gravity):
        if before and moving:  # of gravity's way, accelerate_then_move has all in v
            rest = share if motion == "parabola" else 0
            end = [x + h * (y + rest * g) for x, y, g in zip(center, v, fall)]
        late = [y + (not early) * g for y, g in zip(v, fall)]
        states.append({"position": written_velocity(end), "velocity": written_velocity(late)})
    return {"contacts": [[i, j] for i, j, _ in contacts], "bodies": states}, None
