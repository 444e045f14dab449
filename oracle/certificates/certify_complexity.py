# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for meshes as surfaces, as in check_complexity.cpp."""

import json
from collections import defaultdict

from certify_meshes import height, named_mesh, plane_through
from certify_polygon_faces import sides
from certify_reading import expect
from certify_solids import crossing
from certify_space import cross, dot


def root_in(up, v):
    up.setdefault(v, v)
    while up[v] != v:
        v = up[v]
    return v


def joined(pairs):
    """Which representative each of what the pairs join has."""
    up = {}
    for a, b in pairs:
        p, q = root_in(up, a), root_in(up, b)
        up[p] = q
    return {v: root_in(up, v) for v in list(up)}


def sign(value):
    return (value > 0) - (value < 0)


class Space:
    """The triangles of the mesh in space, each with its plane, and the faces as they are named."""

    def __init__(self, vertices, faces, named):
        self.vertices, self.faces = vertices, faces
        self.face_of = [i for i, face in enumerate(named) for _ in face[2:]]
        self.edges = {(i, min(a, b), max(a, b)) for i, face in enumerate(named) for a, b in sides(face)}
        self.cuts = [[] for _ in named]
        for t, i in enumerate(self.face_of):
            self.cuts[i].append(t)
        self.planes = [plane_through(*(vertices[v] for v in face)) for face in faces]
        self.boxes = [[(min(axis), max(axis)) for axis in zip(*(vertices[v] for v in face))] for face in faces]

    def side(self, plane, v):
        return sign(height(plane, self.vertices[v]))

    def beside(self, i, j):
        """All corners of face j but the common ones are on one side of the plane of face i."""
        sides = {self.side(self.planes[i], v) for v in self.faces[j] if v not in self.faces[i]}
        return len(sides) == 1 and sides != {0}

    def share_a_diagonal(self, i, j):
        """Both triangles name two vertices between which one of their faces has no edge."""
        common = sorted(set(self.faces[i]) & set(self.faces[j]))
        pairs = [(a, b) for a in common for b in common if a < b]
        return any((self.face_of[t], a, b) not in self.edges for a, b in pairs for t in (i, j))

    def held_apart(self, normal, i, j):
        """The plane across the normal through the farthest corner of face i has face j on its other side; and on it, of
        one of the two, nothing but common corners."""
        s, t = self.faces[i], self.faces[j]
        of_s, of_t = [[dot(normal, self.vertices[v]) for v in face] for face in (s, t)]
        top, bottom = max(of_s), min(of_t)
        only_common = [all(at != top or v in other for at, v in zip(along, face))
                       for along, face, other in ((of_s, s, t), (of_t, t, s))]
        return top < bottom or (top == bottom and any(only_common))

    def across_an_axis(self, i, j):
        """One of these planes does that, the normal along an axis."""
        axes = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
        return any(self.boxes[a][k][1] <= self.boxes[b][k][0] and self.held_apart(axis, a, b)
                   for a, b in ((i, j), (j, i)) for k, axis in enumerate(axes))


class Given:
    """Numbers of a fact, so many at a time."""

    def __init__(self, claim, fact):
        self.name, self.values, self.used = "certificate." + fact, claim.list(fact), 0

    def next(self, count):
        expect(self.used + count <= len(self.values), self.name + ": more are needed")
        self.used += count
        return self.values[self.used - count:self.used]

    def expect_used(self):
        expect(self.used == len(self.values), self.name + ": fewer are needed")


def named_pair(claim, faces):
    """The pair of faces that the truth names, or None."""
    if not isinstance(claim.truth, dict) or "meeting_faces" not in claim.truth:
        return None
    pair = claim.truth["meeting_faces"]
    there = (isinstance(pair, list) and len(pair) == 2 and all(type(n) is int for n in pair)
             and 0 <= pair[0] < pair[1] < faces)
    expect(there, "truth: meeting_faces is wrong")
    return tuple(pair)


def expect_meeting(space, i, j, weights):
    """The weights give one point of both triangles, which common corners and common edges of their faces do not span."""
    s, t = space.faces[i], space.faces[j]
    points, beyond = [], set(s) == set(t)
    for face, other in ((s, t), (t, s)):
        total, combination, positive = 0, (0, 0, 0), 0
        for v in face:
            (weight,) = weights.next(1)
            expect(weight >= 0, "certificate: a weight is negative")
            total += weight
            positive += weight > 0
            combination = tuple(c + weight * x for c, x in zip(combination, space.vertices[v]))
            beyond = beyond or (weight > 0 and v not in other)
        expect(total == 1, "certificate: the weights do not sum to 1")
        beyond = beyond or (positive == 2 and len(set(s) & set(t)) == 2 and space.share_a_diagonal(i, j))
        points.append(combination)
    expect(points[0] == points[1], "certificate: the weights give two points")
    expect(beyond, "certificate: the faces share the point")


def expect_apart(space, i, j, normals):
    """Triangles i and j of two faces have nothing in common but corners and edges of both."""
    both = f"faces {space.face_of[i]} and {space.face_of[j]}"
    expect(set(space.faces[i]) != set(space.faces[j]), f"certificate: {both} coincide")
    expect(not space.share_a_diagonal(i, j), f"certificate: {both} share a diagonal")
    if space.across_an_axis(i, j) or space.beside(i, j) or space.beside(j, i):
        return
    expect(space.held_apart(normals.next(3), i, j), f"certificate.normals: {both} are not held apart")


def first_meeting(claim, space, normals, weights):
    """Among faces with areas, finds the first pair, in the order of their indices, that meets beyond what both name.
    Where faces are cut, `triangles` names one of each."""
    named = named_pair(claim, len(space.cuts))
    for i, cut in enumerate(space.cuts):
        for j in range(i + 1, len(space.cuts)):
            if named == (i, j):
                s, t = cut[0], space.cuts[j][0]
                if "cut" in claim.input["mesh"]:
                    places = Given(claim, "triangles")
                    s, t = places.next(2)
                    places.expect_used()
                    expect(s in cut and t in space.cuts[j], "certificate.triangles: none of the face")
                expect_meeting(space, int(s), int(t), weights)
                return [i, j]
            for s in cut:
                for t in space.cuts[j]:
                    expect_apart(space, s, t, normals)
    return None


def first_splitting_face(space, used):
    for i, plane in enumerate(space.planes):
        first = {}
        for v in used:
            first.setdefault(space.side(plane, v), v)
        if {1, -1} <= set(first):
            one, other = sorted((first[1], first[-1]))
            return {"face": space.face_of[i], "one": one, "other": other}
    return None


def inside(vertices, faces, p, directions):
    """The ray from the point in the next direction crosses an odd number of the faces; where the point is not in the
    box of all of them, it is outside."""
    corners = [vertices[v] for face in faces for v in face]
    if not all(min(axis) <= x <= max(axis) for axis, x in zip(zip(*corners), p)):
        return False
    direction = directions.next(3)
    seen = [[tuple(x - y for x, y in zip(vertices[v], p)) for v in face] for face in faces]
    return sum(crossing(face, direction) is not None for face in seen) % 2 == 1


def nesting(vertices, components, directions):
    return [[i, j] for i, outer in enumerate(components) for j, inner in enumerate(components)
            if i != j and inside(vertices, outer, vertices[inner[0][0]], directions)]


def sign_of_volume(vertices, faces):
    six_times = sum(dot(vertices[a], cross(vertices[b], vertices[c])) for a, b, c in faces)
    return ("zero", "positive", "negative")[sign(six_times)]


def check_polyhedron_complexity(claim):
    claim.inputs("mesh")
    vertices, faces, named = named_mesh(claim.input["mesh"], "mesh")
    cut = ["triangles"] if "cut" in claim.input["mesh"] else []
    claim.expect_kind("complexity"), claim.facts("normals", "common_point", "directions", *cut)
    uses, around, whole = defaultdict(lambda: [0, 0]), defaultdict(list), []
    for face in named:
        for a, b, c in zip(face, face[1:] + face[:1], face[-1:] + face[:-1]):
            uses[min(a, b), max(a, b)][a > b] += 1
            whole.append((a, b)), around[a].append((b, c))
    root, numbered = joined(whole), defaultdict(list)
    for face in faces:
        numbered[root[face[0]]].append(face)
    components = list(numbered.values())

    def first_edge(defective):
        return min((list(edge) for edge, use in uses.items() if defective(*use)), default=None)

    used, space = sorted(around), Space(vertices, faces, named)
    pinched = next((v for v in used if len(set(joined(around[v]).values())) != 1), None)
    flat = next((space.face_of[i] for i, (normal, _) in enumerate(space.planes) if normal == (0, 0, 0)), None)
    opened = first_edge(lambda forth, back: (forth + back) % 2 != 0)
    turned = first_edge(lambda forth, back: abs(forth - back) > 1)
    crowded = first_edge(lambda forth, back: forth + back > 2)
    normals, weights, directions = (Given(claim, fact) for fact in ("normals", "common_point", "directions"))
    meeting = first_meeting(claim, space, normals, weights) if flat is None else None
    if cut and meeting is None:
        Given(claim, "triangles").expect_used()
    embedded = flat is None and meeting is None
    solid = embedded and opened is None
    splitting = first_splitting_face(space, used) if solid else None
    nested = nesting(vertices, components, directions) if solid else None
    normals.expect_used(), weights.expect_used(), directions.expect_used()
    answers = {"vertices": len(around), "edges": len(uses), "faces": len(named), "components": len(components),
               "euler": str(len(around) - len(uses) + len(named)),
               "volume": sign_of_volume(vertices, faces) if opened is None and turned is None else "none",
               "closed": opened is None, "oriented": turned is None, "edge_manifold": crowded is None,
               "vertex_manifold": crowded is None and pinched is None, "embedded": embedded,
               "convex": solid and splitting is None, "open_edge": opened, "turned_edge": turned,
               "crowded_edge": crowded, "pinched_vertex": pinched, "flat_face": flat, "meeting_faces": meeting,
               "splitting_face": splitting, "nesting": nested}
    expect(isinstance(claim.truth, dict), "truth: an object")
    for name, answer in answers.items():
        if name in claim.truth:
            right = json.dumps(claim.truth[name], sort_keys=True) == json.dumps(answer, sort_keys=True)
        else:
            right = answer is None
        expect(right, f"truth: {name} is wrong")
    there = sum(answer is not None for answer in answers.values())
    expect(len(claim.truth) == there, "truth: an unexpected field")
