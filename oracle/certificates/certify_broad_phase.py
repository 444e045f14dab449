# SPDX-License-Identifier: Apache-2.0
"""Which solids of a list meet, as in check_broad_phase.cpp, where the proof is written down."""

from certify_pair_tree import expect_pair_tree
from certify_reading import WRONG_KIND, Claim, expect, only
from certify_space import ball, box_holds, box_in_space, dot, exact_triple, point_in_space, triple


class Ball:
    def __init__(self, value, what):
        self.center, self.radius = ball(value, what)
        self.low = [c - self.radius for c in self.center]
        self.high = [c + self.radius for c in self.center]

    def holds(self, p):
        return squared_distance(self.center, p) <= self.radius**2


class Box:
    def __init__(self, value, what):
        self.low, self.high = box_in_space(value, what)

    def holds(self, p):
        return box_holds(self.low, self.high, p)


def squared_distance(p, q):
    between = [b - a for a, b in zip(p, q)]
    return dot(between, between)


def solids(claim):
    """Either field."""
    boxes = isinstance(claim.input, dict) and "boxes" in claim.input
    field = "boxes" if boxes else "spheres"
    claim.inputs(field)
    values = claim.input[field]
    expect(isinstance(values, list), field + ": a list")
    return [(Box if boxes else Ball)(value, f"{field}[{i}]") for i, value in enumerate(values)]


def axis(claim):
    which = claim.single("axis")
    expect(which in (0, 1, 2), "certificate: not an axis")
    return int(which)


def place(index, size):
    expect(index.denominator == 1 and 0 <= index < size, "certificate: not an index")
    return int(index)


def proof_of(claim, written):
    return Claim({"input": claim.input, "truth": claim.truth, "certificate": written})


def proved_to_meet(claim, everything):
    """The truth's pairs, with a common point each."""
    listed, proofs = claim.truth["pairs"], claim.certificate["meet"]
    expect(isinstance(listed, list), "truth.pairs: a list")
    expect(isinstance(proofs, list), "certificate.meet: a list")
    expect(len(listed) == len(proofs), "certificate: a common point for each pair")
    pairs, last = set(), (-1, -1)
    for pair, written in zip(listed, proofs):
        expect(isinstance(pair, list) and len(pair) == 2, "truth.pairs: a list of two in each place")
        for index in pair:
            expect(type(index) is int and 0 <= index < len(everything), "truth.pairs: not an index")
        i, j = pair
        expect(i < j and last < (i, j), "truth: the pairs are not sorted")
        proof = proof_of(claim, written)
        proof.expect_kind("common_point"), proof.facts("point")
        p = exact_triple(written["point"], "certificate.point")
        expect(everything[i].holds(p) and everything[j].holds(p), "certificate: a point is not in both")
        last = (i, j)
        pairs.add(last)
    return pairs


def proved_apart(claim, everything):
    """The pairs that have a proof of their own to be apart."""
    expect(isinstance(claim.certificate["apart"], list), "certificate.apart: a list")
    pairs = set()
    for written in claim.certificate["apart"]:
        proof = proof_of(claim, written)
        distance = proof.kind() == "distance"
        expect(distance or proof.kind() == "gap", WRONG_KIND)
        proof.facts("pair", "squared_distance" if distance else "axis")
        i, j = (place(index, len(everything)) for index in proof.pair("pair"))
        expect(i < j, "certificate: not a pair i < j")
        a, b = everything[i], everything[j]
        if distance:
            expect(isinstance(a, Ball), WRONG_KIND)
            squared = squared_distance(a.center, b.center)
            expect(proof.single("squared_distance") == squared, "certificate: the squared distance is wrong")
            expect(squared > (a.radius + b.radius) ** 2, "certificate: a pair is not apart")
        else:
            along = axis(proof)
            gap = a.high[along] < b.low[along] or b.high[along] < a.low[along]
            expect(gap, "certificate: a pair is not apart")
        expect((i, j) not in pairs, "certificate: a pair is listed twice")
        pairs.add((i, j))
    return pairs


def check_all_pairs(claim):
    if isinstance(claim.certificate, dict) and claim.certificate.get("kind") == "tree":
        expect_pair_tree(claim)
        return
    everything = solids(claim)
    claim.answers("pairs")
    claim.expect_kind("sweep"), claim.facts("axis", "order", "meet", "apart")
    meeting, apart = proved_to_meet(claim, everything), proved_apart(claim, everything)
    along = axis(claim)
    order, seen = [], set()
    for index in claim.list("order"):
        order.append(place(index, len(everything)))
        expect(order[-1] not in seen, "certificate: the order has a place twice")
        seen.add(order[-1])
    expect(len(order) == len(everything), "certificate: the order is not of all")
    for i, j in zip(order, order[1:]):
        expect(everything[i].low[along] <= everything[j].low[along], "certificate: the order is not that of the axis")
    for p, i in enumerate(order):
        for q in range(p + 1, len(order)):
            j = order[q]
            if everything[j].low[along] > everything[i].high[along]:
                break
            pair = (min(i, j), max(i, j))
            expect((pair in meeting) + (pair in apart) == 1, "certificate: a pair is left open")


def body(bodies, index, what):
    expect(type(index) is int and index in bodies, what + ": index of a body that is there")
    return index


def ray_in_space(value, what):
    only(value, what, ["origin", "direction"])
    origin = point_in_space(value["origin"], what + ".origin")
    direction = point_in_space(value["direction"], what + ".direction")
    expect(direction != (0, 0, 0), what + ".direction: nonzero direction")
    return origin, direction


def query(command, what):
    if "in_box" in command:
        only(command, what, ["in_box"]), box_in_space(command["in_box"], what + ".in_box")
    elif "at_point" in command:
        only(command, what, ["at_point"]), point_in_space(command["at_point"], what + ".at_point")
    elif "along_ray" in command:
        only(command, what, ["along_ray"]), ray_in_space(command["along_ray"], what + ".along_ray")
    else:
        only(command, what, ["ask"])
        expect(command["ask"] == "pairs", what + ".ask: pairs")


def carry_out(command, bodies, count, what):
    """How many bodies there have been after the command."""
    expect(isinstance(command, dict), what + ": a command")
    if "insert" in command:
        only(command, what, ["insert"])
        box_in_space(command["insert"], what + ".insert")
        bodies[count] = command["insert"]
        return count + 1
    if "move" in command:
        only(command, what, ["move", "box"])
        index = body(bodies, command["move"], what + ".move")
        box_in_space(command["box"], what + ".box")
        bodies[index] = command["box"]
    elif "remove" in command:
        only(command, what, ["remove"])
        del bodies[body(bodies, command["remove"], what + ".remove")]
    else:
        query(command, what)
    return count


def worlds(claim):
    """Each query, and the bodies that are there."""
    expect(isinstance(claim.input["boxes"], list), "boxes: a list")
    bodies, count = {}, 0
    for box in claim.input["boxes"]:
        box_in_space(box, f"boxes[{count}]")
        bodies[count] = box
        count += 1
    expect(isinstance(claim.input["commands"], list), "commands: a list")
    for i, command in enumerate(claim.input["commands"]):
        count = carry_out(command, bodies, count, f"commands[{i}]")
        if not {"insert", "move", "remove"} & set(command):
            yield command, dict(bodies)


def check_pairs(bodies, reply, certificate):
    """That of all_pairs, where the bodies that are there have their places in the list."""
    only(reply, "truth.replies", ["pairs"])
    expect(isinstance(reply["pairs"], list), "truth.pairs: a list")
    places = {index: place for place, index in enumerate(sorted(bodies))}
    pairs = []
    for pair in reply["pairs"]:
        expect(isinstance(pair, list) and len(pair) == 2, "truth.pairs: a list of two in each place")
        pairs.append([places[body(bodies, index, "truth.pairs")] for index in pair])
    boxes = [bodies[index] for index in sorted(bodies)]
    check_all_pairs(Claim({"input": {"boxes": boxes}, "truth": {"pairs": pairs}, "certificate": certificate}))


def meets_box(proof, low, high, body_low, body_high):
    """Whether a body meets a box, as the proof says."""
    if proof.kind() == "common_point":
        proof.facts("point")
        p = triple(proof, "point")
        expect(box_holds(low, high, p) and box_holds(body_low, body_high, p), "certificate: a point is not in both")
        return True
    proof.expect_kind("gap"), proof.facts("axis")
    along = axis(proof)
    gap = high[along] < body_low[along] or body_high[along] < low[along]
    expect(gap, "certificate: a body is not apart")
    return False


def first_on_ray(proof, origin, direction, low, high):
    """The first t at which a ray is in a body, as the proof says; None: never."""
    if proof.kind() == "apart":
        proof.facts("below", "above")
        below, above = proof.list("below"), proof.list("above")
        expect(len(below) == 3 and len(above) == 3, "certificate: a weight for each face")
        expect(all(weight >= 0 for weight in below + above), "certificate: a weight is negative")
        total = sum(b * (least - o) + a * (o - most)
                    for b, a, o, least, most in zip(below, above, origin, low, high))
        slope = sum((a - b) * d for b, a, d in zip(below, above, direction))
        expect(total > 0 and slope >= 0, "certificate: the weights prove nothing")
        return None
    start = proof.kind() == "start"
    expect(start or proof.kind() == "entry", WRONG_KIND)
    proof.facts(*([] if start else ["first", "axis"]))
    first = 0 if start else proof.single("first")
    expect(first >= 0, "certificate: before the ray starts")
    p = [o + first * d for o, d in zip(origin, direction)]
    expect(box_holds(low, high, p), "certificate: the ray is not in the body")
    if not start:
        k = axis(proof)
        enters = (direction[k] > 0 and p[k] == low[k]) or (direction[k] < 0 and p[k] == high[k])
        expect(enters, "certificate: the ray does not enter there")
    return first


def met(command, bodies, proofs):
    """The bodies that the proofs, one for each, show to be met: of a ray, in the order of the first t."""
    found = []
    for index, written in zip(sorted(bodies), proofs):
        low, high = box_in_space(bodies[index], "body")
        proof = Claim({"input": command, "truth": command, "certificate": written})
        if "along_ray" in command:
            first = first_on_ray(proof, *ray_in_space(command["along_ray"], "ray"), low, high)
            found += [] if first is None else [(first, index)]
        else:
            p = command.get("at_point")
            ends = box_in_space(command["in_box"], "box") if p is None else (point_in_space(p, "point"),) * 2
            found += [(0, index)] if meets_box(proof, *ends, low, high) else []
    return [index for _, index in sorted(found)]


def check_reply(command, bodies, reply, certificate):
    if "ask" in command:
        return check_pairs(bodies, reply, certificate)
    name, kind = ("in_order", "each_along") if "along_ray" in command else ("bodies", "each_body")
    only(reply, "truth.replies", [name])
    expect(isinstance(reply[name], list), f"truth.{name}: a list")
    expected = [body(bodies, index, "truth." + name) for index in reply[name]]
    claim = Claim({"input": command, "truth": reply, "certificate": certificate})
    claim.expect_kind(kind), claim.facts("each")
    expect(isinstance(certificate["each"], list), "certificate.each: a list")
    expect(len(certificate["each"]) == len(bodies), "certificate: a proof for each body")
    expect(met(command, bodies, certificate["each"]) == expected, "truth: not the bodies that are proved")


def check_broad_phase(claim):
    claim.inputs("boxes", "commands")
    asked = list(worlds(claim))
    claim.answers("replies")
    claim.expect_kind("replies"), claim.facts("replies")
    replies, proofs = claim.truth["replies"], claim.certificate["replies"]
    expect(isinstance(replies, list), "truth.replies: a list")
    expect(isinstance(proofs, list), "certificate.replies: a list")
    expect(len(asked) == len(replies) == len(proofs), "certificate: a reply and its proof for each query")
    for (command, bodies), reply, proof in zip(asked, replies, proofs):
        check_reply(command, bodies, reply, proof)


# What other structures answer is proved in the same way.
check_sphere_hierarchy = check_all_pairs
check_bounding_volume_hierarchy = check_uniform_grid = check_broad_phase
check_quadtree = check_octree = check_bsp_tree = check_broad_phase
