# SPDX-License-Identifier: Apache-2.0
"""Which bodies a box, a point or a ray meets, as in check_broad_phase.cpp, where the proof is written down."""

from certify_reading import WRONG_KIND, Claim, expect, only
from certify_space import box_holds, box_in_space, point_in_space, triple

DEEPEST = 4096


def axis(claim):
    which = claim.single("axis")
    expect(which in (0, 1, 2), "certificate: not an axis")
    return int(which)


def place(index, size):
    expect(index.denominator == 1 and 0 <= index < size, "certificate: not an index")
    return int(index)


def ray_in_space(value, what):
    only(value, what, ["origin", "direction"])
    origin = point_in_space(value["origin"], what + ".origin")
    direction = point_in_space(value["direction"], what + ".direction")
    expect(direction != (0, 0, 0), what + ".direction: nonzero direction")
    return origin, direction


def meets_box(proof, low, high, body_low, body_high):
    """Returns whether a body meets a box, as the proof says."""
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


class Met:
    """The bodies that a query meets, by one proof after another."""

    def __init__(self, command, proofs):
        self.command, self.proofs, self.used, self.met = command, proofs, 0, []
        self.of_ray = "along_ray" in command
        if self.of_ray:
            self.ends = ray_in_space(command["along_ray"], "ray")
        elif "in_box" in command:
            self.ends = box_in_space(command["in_box"], "box")
        else:
            self.ends = (point_in_space(command["at_point"], "point"),) * 2

    def next(self):
        expect(self.used < len(self.proofs), "certificate: a proof for each body")
        self.used += 1
        proof = self.proofs[self.used - 1]
        return Claim({"input": self.command, "truth": self.command, "certificate": proof})

    def first(self, proof, low, high):
        if self.of_ray:
            return first_on_ray(proof, *self.ends, low, high)
        return 0 if meets_box(proof, *self.ends, low, high) else None

    def look_at(self, index, low, high):
        first = self.first(self.next(), low, high)
        self.met += [] if first is None else [(first, index)]

    def opens(self, low, high):
        """Returns whether the next proof leaves open what is in the box; else it shows that the query misses it."""
        proof = self.next()
        if proof.kind() == "open":
            proof.facts()
            return True
        expect(self.first(proof, low, high) is None, "certificate: a node is not apart")
        return False

    def bodies(self):
        """Returns the bodies along a ray in the order of the first t."""
        expect(self.used == len(self.proofs), "certificate: a proof for each body")
        return [index for _, index in sorted(self.met)]


class Node:
    def __init__(self, begin, end):
        self.begin, self.end, self.second, self.box = begin, end, 0, None


def around(boxes):
    """None of none."""
    lows, highs = zip(*boxes) if boxes else ((), ())
    return (tuple(map(min, *lows, lows[0])), tuple(map(max, *highs, highs[0]))) if boxes else None


class BodyTree:
    """Each body is in one leaf at most."""

    def __init__(self, claim, count):
        claim.expect_kind("tree"), claim.facts("order", "cuts")
        self.order, self.seen, self.fitted = [], set(), None
        for index in claim.list("order"):
            self.order.append(place(index, count))
            expect(self.order[-1] not in self.seen, "certificate: the order has a place twice")
            self.seen.add(self.order[-1])
        cuts = [place(cut, len(self.order) + 1) for cut in claim.list("cuts")]
        self.nodes, waiting = [], [(0, len(self.order), 0, None)] if self.order else []
        while waiting:
            begin, end, depth, parent = waiting.pop()
            expect(len(self.nodes) < len(cuts), "certificate: the tree has too few nodes")
            expect(depth <= DEEPEST, "certificate: the tree is too deep")
            at, cut = len(self.nodes), cuts[len(self.nodes)]
            self.nodes.append(Node(begin, end))
            if parent is not None:
                self.nodes[parent].second = at
            if cut:
                expect(cut < end - begin, "certificate: a node without bodies")
                waiting += [(begin + cut, end, depth + 1, at), (begin, begin + cut, depth + 1, None)]
        expect(len(self.nodes) == len(cuts), "certificate: the tree has too many nodes")

    def there(self, node, bodies):
        return [index for index in self.order[node.begin : node.end] if index in bodies]

    def fit(self, bodies):
        for at in reversed(range(len(self.nodes))):
            node = self.nodes[at]
            if node.second:
                children = [self.nodes[child].box for child in (at + 1, node.second)]
                node.box = around([box for box in children if box])
            else:
                node.box = around([bodies[index][1] for index in self.there(node, bodies)])

    def look(self, bodies, changes, met):
        if self.fitted != changes:
            self.fit(bodies)
            self.fitted = changes
        waiting = [0] if self.nodes else []
        while waiting:
            at = waiting.pop()
            node = self.nodes[at]
            if not node.box:
                continue
            if not node.second:
                for index in self.there(node, bodies):
                    met.look_at(index, *bodies[index][1])
            elif met.opens(*node.box):
                waiting += [node.second, at + 1]
        for index in sorted(bodies):
            if index not in self.seen:
                met.look_at(index, *bodies[index][1])


class BodyTrees:
    """The trees of a certificate, each read when a query names it first."""

    def __init__(self, claim):
        self.claim, self.written = claim, claim.certificate.get("trees", [])
        expect(isinstance(self.written, list), "certificate.trees: a list")
        self.trees = [None] * len(self.written)

    def named(self, query, count):
        which = place(query.single("tree"), len(self.trees))
        if self.trees[which] is None:
            claim = Claim({"input": self.claim.input, "truth": self.claim.truth, "certificate": self.written[which]})
            self.trees[which] = BodyTree(claim, count)
        return self.trees[which]

    def expect_used(self):
        expect(None not in self.trees, "certificate: a tree of no query")


def met_bodies(query, bodies, count, changes, trees):
    """By their indices, or of a ray in the order of the first t. bodies: what is written and both ends, by index."""
    by_tree = query.kind() == "by_tree"
    expect(by_tree or query.kind() == ("each_along" if "along_ray" in query.input else "each_body"), WRONG_KIND)
    query.facts(*(["tree"] if by_tree else []), "each")
    proofs = query.certificate["each"]
    expect(isinstance(proofs, list), "certificate.each: a list")
    expect(by_tree or len(proofs) == len(bodies), "certificate: a proof for each body")
    met = Met(query.input, proofs)
    if by_tree:
        trees.named(query, count).look(bodies, changes, met)
    else:
        for index in sorted(bodies):
            met.look_at(index, *bodies[index][1])
    return met.bodies()
