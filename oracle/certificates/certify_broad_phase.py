# SPDX-License-Identifier: Apache-2.0
"""Which solids of a list meet, as in check_broad_phase.cpp, where the proof is written down."""

from certify_body_tree import BodyTrees, axis, met_bodies, place, ray_in_space
from certify_pair_tree import expect_pair_tree
from certify_reading import WRONG_KIND, Claim, expect, only
from certify_space import ball, box_holds, box_in_space, dot, exact_triple, point_in_space


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


def are_apart(a, b):
    if isinstance(a, Ball):
        return squared_distance(a.center, b.center) > (a.radius + b.radius) ** 2
    return any(a.high[k] < b.low[k] or b.high[k] < a.low[k] for k in range(3))


def check_all_pairs(claim):
    if isinstance(claim.certificate, dict) and claim.certificate.get("kind") == "tree":
        expect_pair_tree(claim)
        return
    everything = solids(claim)
    claim.answers("pairs")
    compares = claim.kind() == "compared_sweep"
    if not compares:
        claim.expect_kind("sweep")
    claim.facts("axis", "order", "meet", *([] if compares else ["apart"]))
    meeting, apart = proved_to_meet(claim, everything), set() if compares else proved_apart(claim, everything)
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
            asunder = are_apart(everything[i], everything[j]) if compares else pair in apart
            expect((pair in meeting) != asunder, "certificate: a pair is left open")


def body(bodies, index, what):
    expect(type(index) is int and index in bodies, what + ": index of a body that is there")
    return index


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
    """Returns how many bodies there have been after the command. bodies: what is written and both ends, by index."""
    expect(isinstance(command, dict), what + ": a command")
    if "insert" in command:
        only(command, what, ["insert"])
        bodies[count] = command["insert"], box_in_space(command["insert"], what + ".insert")
        return count + 1
    if "move" in command:
        only(command, what, ["move", "box"])
        index = body(bodies, command["move"], what + ".move")
        bodies[index] = command["box"], box_in_space(command["box"], what + ".box")
    elif "remove" in command:
        only(command, what, ["remove"])
        del bodies[body(bodies, command["remove"], what + ".remove")]
    else:
        query(command, what)
    return count


def worlds(claim):
    """Each query, the bodies that are there, how many there have been, and the command's place."""
    expect(isinstance(claim.input["boxes"], list), "boxes: a list")
    bodies, count, changes = {}, 0, 0
    for box in claim.input["boxes"]:
        bodies[count] = box, box_in_space(box, f"boxes[{count}]")
        count += 1
    expect(isinstance(claim.input["commands"], list), "commands: a list")
    for i, command in enumerate(claim.input["commands"]):
        count = carry_out(command, bodies, count, f"commands[{i}]")
        if {"insert", "move", "remove"} & set(command):
            changes += 1
        else:
            yield command, bodies, count, changes


def check_pairs(bodies, reply, certificate):
    """That of all_pairs, where the bodies that are there have their places in the list."""
    only(reply, "truth.replies", ["pairs"])
    expect(isinstance(reply["pairs"], list), "truth.pairs: a list")
    places = {index: place for place, index in enumerate(sorted(bodies))}
    pairs = []
    for pair in reply["pairs"]:
        expect(isinstance(pair, list) and len(pair) == 2, "truth.pairs: a list of two in each place")
        pairs.append([places[body(bodies, index, "truth.pairs")] for index in pair])
    boxes = [bodies[index][0] for index in sorted(bodies)]
    check_all_pairs(Claim({"input": {"boxes": boxes}, "truth": {"pairs": pairs}, "certificate": certificate}))


def check_reply(command, bodies, count, changes, reply, certificate, trees):
    if "ask" in command:
        return check_pairs(bodies, reply, certificate)
    name = "in_order" if "along_ray" in command else "bodies"
    only(reply, "truth.replies", [name])
    expect(isinstance(reply[name], list), f"truth.{name}: a list")
    expected = [body(bodies, index, "truth." + name) for index in reply[name]]
    claim = Claim({"input": command, "truth": reply, "certificate": certificate})
    found = met_bodies(claim, bodies, count, changes, trees)
    expect(found == expected, "truth: not the bodies that are proved")


def check_broad_phase(claim):
    claim.inputs("boxes", "commands")
    queries = sum(1 for _ in worlds(claim))
    claim.answers("replies")
    claim.expect_kind("replies"), claim.facts("replies", *(["trees"] if "trees" in claim.certificate else []))
    replies, proofs = claim.truth["replies"], claim.certificate["replies"]
    expect(isinstance(replies, list), "truth.replies: a list")
    expect(isinstance(proofs, list), "certificate.replies: a list")
    expect(queries == len(replies) == len(proofs), "certificate: a reply and its proof for each query")
    trees = BodyTrees(claim)
    for (command, *world), reply, proof in zip(worlds(claim), replies, proofs):
        check_reply(command, *world, reply, proof, trees)
    trees.expect_used()


# The answers of other structures are proved in the same way.
check_sphere_hierarchy = check_all_pairs
check_bounding_volume_hierarchy = check_uniform_grid = check_broad_phase
check_quadtree = check_octree = check_bsp_tree = check_broad_phase
