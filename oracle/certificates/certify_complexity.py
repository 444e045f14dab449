# SPDX-License-Identifier: Apache-2.0
"""What certify.py checks of meshes as surfaces, as in check_complexity.cpp."""

from collections import defaultdict

from certify_meshes import mesh
from certify_reading import exact_value, expect


def parts(pairs):
    """How many parts there are of what the pairs join."""
    up = {}

    def root(v):
        up.setdefault(v, v)
        while up[v] != v:
            v = up[v]
        return v

    for a, b in pairs:
        p, q = root(a), root(b)
        up[p] = q
    return len({root(v) for v in list(up)})


def expect_flag(claim, word, value):
    expect(claim.truth[word] is value, f"truth: {word} is wrong")


def expect_word(claim, word, fact, defective):
    """The word is false where an edge is named, one of the defective ones; else there is none of these."""
    named = claim.list(fact)
    if any(named == list(edge) for edge in defective):
        return expect_flag(claim, word, False)
    expect(not named, f"certificate.{fact}: no such edge")
    expect(not defective, f"certificate.{fact}: there is one")
    expect_flag(claim, word, True)


def expect_count(claim, name, count):
    said = claim.truth[name]
    expect(isinstance(said, int) and not isinstance(said, bool) and said == count, f"truth: {name} is wrong")


def check_polyhedron_complexity(claim):
    claim.inputs("mesh")
    _, faces = mesh(claim.input["mesh"], "mesh")
    uses, around, whole = defaultdict(lambda: [0, 0]), defaultdict(list), []
    for face in faces:
        for a, b, c in (face, face[1:] + face[:1], face[2:] + face[:2]):
            uses[min(a, b), max(a, b)][a > b] += 1
            whole.append((a, b)), around[a].append((b, c))
    claim.answers("vertices", "edges", "faces", "components", "euler", "closed", "oriented", "edge_manifold",
                  "vertex_manifold")
    claim.expect_kind("complexity"), claim.facts("open_edge", "turned_edge", "crowded_edge", "pinched_vertex")
    expect_count(claim, "vertices", len(around)), expect_count(claim, "edges", len(uses))
    expect_count(claim, "faces", len(faces)), expect_count(claim, "components", parts(whole))
    euler = len(around) - len(uses) + len(faces)
    expect(exact_value(claim.truth["euler"], "truth.euler") == euler, "truth: euler is wrong")
    expect_word(claim, "closed", "open_edge", [edge for edge, use in uses.items() if sum(use) % 2 != 0])
    expect_word(claim, "oriented", "turned_edge", [edge for edge, use in uses.items() if abs(use[0] - use[1]) > 1])
    expect_word(claim, "edge_manifold", "crowded_edge", [edge for edge, use in uses.items() if sum(use) > 2])
    pinched, named = [vertex for vertex, pairs in around.items() if parts(pairs) != 1], claim.list("pinched_vertex")
    there = any(named == [vertex] for vertex in pinched)
    expect(there or not named, "certificate.pinched_vertex: no such vertex")
    expect(there or not pinched, "certificate.pinched_vertex: there is one")
    expect_flag(claim, "vertex_manifold", not pinched and claim.truth["edge_manifold"] is True)
