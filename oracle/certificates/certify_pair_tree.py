# SPDX-License-Identifier: Apache-2.0
"""Which boxes of a long list meet, as in check_pair_tree.cpp, where the proof is written down."""

import base64
import math
import struct

from certify_reading import Refusal, expect

LARGEST_LEAF, DEEPEST = 16, 4096


def packed(value, what, letter):
    """A list in one string: base64 of its bytes, numbers with the lowest byte first."""
    size = struct.calcsize("<" + letter)
    malformed = f"{what}: base64 of {size} bytes an element"
    expect(isinstance(value, str), malformed)
    try:
        held = base64.b64decode(value, validate=True)
    except ValueError:
        raise Refusal(malformed) from None
    expect(base64.b64encode(held).decode() == value and len(held) % size == 0, malformed)
    return struct.unpack(f"<{len(held) // size}{letter}", held)


def boxes_of(numbers):
    expect(len(numbers) % 6 == 0, "boxes: six numbers a box")
    for n, x in enumerate(numbers):
        expect(math.isfinite(x), f"boxes[{n // 6}].{'min' if n % 6 < 3 else 'max'}[{n % 3}]: finite number")
    for n, x in enumerate(numbers):
        expect(n % 6 < 3 or numbers[n - 3] <= x, f"boxes[{n // 6}].max[{n % 3}]: min <= max")
    return [numbers[n : n + 6] for n in range(0, len(numbers), 6)]


def meet(a, b):
    return all(a[k] <= b[k + 3] and b[k] <= a[k + 3] for k in range(3))


def around(a, b):
    return tuple(map(min, a[:3], b[:3])) + tuple(map(max, a[3:], b[3:]))


def expect_pairs_meet(pairs, boxes):
    expect(len(pairs) % 2 == 0, "truth.pairs: two indices a pair")
    last = (-1, -1)
    for i, j in zip(pairs[::2], pairs[1::2]):
        expect(i < len(boxes) and j < len(boxes), "truth.pairs: not an index")
        expect(i < j and last < (i, j), "truth: the pairs are not sorted")
        expect(meet(boxes[i], boxes[j]), "truth: a pair does not meet")
        last = (i, j)


def ordered(order, boxes):
    seen = set()
    for i in order:
        expect(i < len(boxes), "certificate: not an index")
        expect(i not in seen, "certificate: the order has a place twice")
        seen.add(i)
    expect(len(order) == len(boxes), "certificate: the order is not of all")
    return [boxes[i] for i in order]


class Node:
    def __init__(self, begin, end):
        self.begin, self.end, self.second, self.box = begin, end, 0, None


def tree(cuts, boxes):
    """The nodes in preorder; the first child of one with a second is the next."""
    nodes, waiting = [], [(0, len(boxes), 0, None)] if boxes else []
    while waiting:
        begin, end, depth, parent = waiting.pop()
        expect(len(nodes) < len(cuts), "certificate: the tree has too few nodes")
        expect(depth <= DEEPEST, "certificate: the tree is too deep")
        cut, place = cuts[len(nodes)], len(nodes)
        nodes.append(Node(begin, end))
        if parent is not None:
            nodes[parent].second = place
        if cut == 0:
            expect(end - begin <= LARGEST_LEAF, "certificate: a leaf of more than 16 boxes")
        else:
            expect(cut < end - begin, "certificate: a node without boxes")
            waiting += [(begin + cut, end, depth + 1, place), (begin, begin + cut, depth + 1, None)]
    expect(len(nodes) == len(cuts), "certificate: the tree has too many nodes")
    for place in reversed(range(len(nodes))):
        node = nodes[place]
        if node.second:
            node.box = around(nodes[place + 1].box, nodes[node.second].box)
        else:
            node.box = boxes[node.begin]
            for box in boxes[node.begin + 1 : node.end]:
                node.box = around(node.box, box)
    return nodes


def count(nodes, boxes, steps):
    """Counts the pairs that meet, by the steps."""
    found = taken = 0
    waiting = [(0, 0)] if nodes else []
    while waiting:
        one, other = waiting.pop()
        a, b = nodes[one], nodes[other]
        if one == other:
            if a.second:
                waiting += [(one + 1, a.second), (a.second, a.second), (one + 1, one + 1)]
            else:
                own = boxes[a.begin : a.end]
                found += sum(meet(box, later) for i, box in enumerate(own) for later in own[i + 1 :])
            continue
        expect(taken // 4 < len(steps), "certificate: too few steps")
        step = steps[taken // 4] >> (2 * (taken % 4)) & 3
        taken += 1
        if step == 0:
            expect(not meet(a.box, b.box), "certificate: nodes are not apart")
        elif step == 1:
            expect(a.second, "certificate: a leaf is opened")
            waiting += [(a.second, other), (one + 1, other)]
        elif step == 2:
            expect(b.second, "certificate: a leaf is opened")
            waiting += [(one, b.second), (one, other + 1)]
        else:
            expect(not a.second and not b.second, "certificate: a node is no leaf")
            near = [box for box in boxes[a.begin : a.end] if meet(box, b.box)]
            found += sum(meet(box, other_box) for box in near for other_box in boxes[b.begin : b.end])
    rest = taken % 4 == 0 or steps[-1] >> (2 * (taken % 4)) == 0
    expect((taken + 3) // 4 == len(steps) and rest, "certificate: too many steps")
    return found


def expect_pair_tree(claim):
    claim.inputs("boxes")
    boxes = boxes_of(packed(claim.input["boxes"], "boxes", "d"))
    claim.answers("pairs")
    claim.facts("order", "cuts", "steps")
    pairs = packed(claim.truth["pairs"], "truth.pairs", "I")
    order = packed(claim.certificate["order"], "certificate.order", "I")
    cuts = packed(claim.certificate["cuts"], "certificate.cuts", "I")
    steps = packed(claim.certificate["steps"], "certificate.steps", "B")
    expect_pairs_meet(pairs, boxes)
    in_order = ordered(order, boxes)
    nodes = tree(cuts, in_order)
    expect(count(nodes, in_order, steps) == len(pairs) // 2, "truth: a pair is missing")
