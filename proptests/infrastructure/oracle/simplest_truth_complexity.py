# SPDX-License-Identifier: Apache-2.0
"""The second truth of meshes as surfaces: at each vertex the edges away from it are walked along, from face to face, as
are all faces from one of them; two faces meet where an edge of one is in the other."""
import json
from functools import cache
from itertools import combinations
from math import lcm

from simplest_truth_polyhedra import cross, truth_point_in_polyhedron, volume
from simplest_truth_reading import dot, minus, point, triangles
from simplest_truth_triangles import at, common_interval


def pieces(sets):
    sets = list(map(set, sets))
    for i in range(len(sets)):  # each into a later one that it meets
        later = next((other for other in sets[i + 1:] if other & sets[i]), None)
        if later is not None:
            later |= sets[i]
            sets[i] = set()
    return [piece for piece in sets if piece]


def meet(vertices, s, t):
    """An edge of one is in the other at a point that is not on what both name."""
    shared = [vertices[v] for v in s if v in t]
    for face, other in ((s, t), (t, s)):
        for ends in combinations([vertices[v] for v in face], 2):
            for parameter in common_interval(ends, [vertices[v] for v in other]) or ():
                off = [minus(at(ends, parameter), v) for v in shared]
                if len(shared) in (0, 3) or (any(off[0]) if len(shared) == 1 else any(cross(*off))):
                    return True
    return False


def along_a_diagonal(faces, cuts, i, j):
    """A side of a triangle of one is a side of one of the other, but no edge of both faces."""
    sides = [{frozenset(side) for t in cuts[k] for side in combinations(t, 2)} for k in (i, j)]
    edges = [set(map(frozenset, zip(faces[k], faces[k][1:] + faces[k][:1]))) for k in (i, j)]
    return bool(sides[0] & sides[1] - edges[0] & edges[1])


def boxes_meet(s, t):
    return all(max(a) >= min(b) and max(b) >= min(a) for a, b in zip(zip(*s), zip(*t)))


def truth_polyhedron_complexity(question):
    return answer_of(json.dumps(question["mesh"])), None


@cache
def answer_of(mesh):
    mesh = json.loads(mesh)
    given, faces = [point(v) for v in mesh["vertices"]], [tuple(face) for face in mesh["faces"]]
    left = iter(map(tuple, triangles(mesh)))
    cuts = [[next(left) for _ in face[2:]] for face in faces]
    scale = lcm(*(x.denominator for v in given for x in v))  # integers are quicker
    vertices = [tuple(int(x * scale) for x in v) for v in given]
    places = [[[vertices[v] for v in t] for t in cut] for cut in cuts]
    corners = [triangle for cut in places for triangle in cut]
    directed = [edge for f in faces for edge in zip(f, f[1:] + f[:1])]
    around = [(v, {before, after}) for f in faces for before, v, after in zip(f[-1:] + f[:-1], f, f[1:] + f[:1])]
    used, edges = sorted({v for f in faces for v in f}), sorted({tuple(sorted(edge)) for edge in directed})
    times = {edge: (directed.count(edge), directed.count(edge[::-1])) for edge in edges}
    parts = [[t for f, cut in zip(faces, cuts) if f[0] in piece for t in cut] for piece in pieces(faces)]
    flattened = [t for cut in cuts for t in cut]
    components = sorted(parts, key=lambda part: flattened.index(part[0]))

    def first(candidates):
        return next(iter(candidates), None)

    answer = {
        "vertices": len(used), "edges": len(edges), "faces": len(faces), "components": len(components),
        "euler": str(len(used) - len(edges) + len(faces)),
        "open_edge": first(list(edge) for edge, both in times.items() if sum(both) % 2 != 0),
        "turned_edge": first(list(edge) for edge, (forth, back) in times.items() if abs(forth - back) > 1),
        "crowded_edge": first(list(edge) for edge, both in times.items() if sum(both) > 2),
        "pinched_vertex": first(v for v in used if len(pieces(ends for u, ends in around if u == v)) > 1),
        "flat_face": first(i for i, cut in enumerate(places) for a, b, c in cut
                           if not any(cross(minus(b, a), minus(c, a))))}
    if answer["flat_face"] is None:
        answer["meeting_faces"] = first(
            [i, j] for i, j in combinations(range(len(faces)), 2)
            if any(boxes_meet(places[i][s], places[j][t]) and meet(vertices, cuts[i][s], cuts[j][t])
                   for s in range(len(cuts[i])) for t in range(len(cuts[j]))) or along_a_diagonal(faces, cuts, i, j))
    words = {"closed": ["open_edge"], "oriented": ["turned_edge"], "edge_manifold": ["crowded_edge"],
             "vertex_manifold": ["crowded_edge", "pinched_vertex"], "embedded": ["flat_face", "meeting_faces"]}
    for word, witnesses in words.items():
        answer[word] = all(answer.get(witness) is None for witness in witnesses)
    answer["volume"], answer["convex"] = "none", False
    if answer["closed"] and answer["oriented"]:
        six_times = sum(volume(vertices[0], *face) for face in corners)
        answer["volume"] = "positive" if six_times > 0 else "negative" if six_times < 0 else "zero"
    if answer["closed"] and answer["embedded"]:
        answer["splitting_face"] = first(splits(vertices, used, [cut[0] for cut in places]))
        answer["convex"] = answer["splitting_face"] is None
        answer["nesting"] = [
            [i, j] for i, outer in enumerate(components) for j, inner in enumerate(components)
            if i != j and boxes_meet([vertices[v] for f in outer for v in f], [vertices[inner[0][0]]])
            and truth_point_in_polyhedron({"mesh": {"vertices": mesh["vertices"], "faces": outer},
                                           "point": mesh["vertices"][inner[0][0]]})[0]["location"] == "inside"]
    return {name: value for name, value in answer.items() if value is not None}


def splits(vertices, used, corners):
    for i, (a, b, c) in enumerate(corners):
        heights = {v: dot(cross(minus(b, a), minus(c, a)), minus(vertices[v], a)) for v in used}
        off = [v for v in used if heights[v] != 0]
        other = [v for v in off if (heights[v] > 0) != (heights[off[0]] > 0)]
        if other:
            yield {"face": i, "one": off[0], "other": other[0]}
