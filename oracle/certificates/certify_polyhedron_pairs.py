# SPDX-License-Identifier: Apache-2.0
"""How the solids within two closed meshes lie to each other, as in check_polyhedron_pairs.cpp, where the proof is
written down."""

from certify_meshes import mesh
from certify_reading import WRONG_KIND, expect
from certify_solids import expect_even, index, proved_location
from certify_space import cross, dot, minus, triple


def named(solid):
    """The places of the vertices that faces name."""
    return sorted({i for face in solid[1] for i in face})


def box_around(solid):
    axes = list(zip(*(solid[0][i] for i in named(solid))))
    return [min(axis) for axis in axes], [max(axis) for axis in axes]


def heights(polygon, half):
    (normal, offset), side = half
    return [side * (dot(normal, p) - offset) for p in polygon]


def clipped(polygon, above):
    """Cuts a convex polygon with these heights at 0 and returns the part that is not below."""
    kept = []
    for i, (p, at_p) in enumerate(zip(polygon, above)):
        q, at_q = polygon[(i + 1) % len(polygon)], above[(i + 1) % len(polygon)]
        if at_p >= 0:
            kept.append(p)
        if at_p * at_q < 0:
            t = at_p / (at_p - at_q)
            kept.append(tuple(x + t * (y - x) for x, y in zip(p, q)))
    return kept


def counts(above, closed):
    return max(above) >= 0 if closed else max(above) > 0


def part(cell, half, closed):
    bounds, pieces = cell
    seen = [[(piece, heights(piece, half)) for piece in of_solid] for of_solid in pieces]
    return bounds + [half], [[clipped(piece, above) for piece, above in of_solid if counts(above, closed)]
                             for of_solid in seen]


def all_of_space(solids, closed):
    faces = [[[vertices[i] for i in face] for face in faces] for vertices, faces in solids]
    has_area = [[cross(minus(b, a), minus(c, a)) != (0, 0, 0) for a, b, c in of_solid] for of_solid in faces]
    return [], [[face for face, area in zip(*of_solid) if closed or area] for of_solid in zip(faces, has_area)]


def expect_partition(claim, solids, closed):
    tree, planes, points = claim.list("tree"), claim.list("planes"), claim.list("points")
    outside = claim.proofs("outside")
    cuts = tree.count(2)
    same = len(planes) == 4 * cuts and len(points) == 3 * len(outside) and len(tree) == cuts + len(outside)
    expect(same, "certificate: planes, points and proofs are not those of the tree")
    planes = iter([(tuple(planes[i:i + 3]), planes[i + 3]) for i in range(0, len(planes), 4)])
    ends = iter([(tuple(points[3 * i:3 * i + 3]), proof) for i, proof in enumerate(outside)])
    left = [all_of_space(solids, closed)]
    for node in tree:
        expect(left, "certificate: the tree goes on after its end")
        cell = left.pop()
        if node == 2:
            plane = next(planes)
            left += [part(cell, (plane, -1), closed), part(cell, (plane, 1), closed)]
            continue
        (bounds, pieces), solid, (p, proof) = cell, index(node, 2), next(ends)
        expect(not pieces[solid], "certificate: a face enters a cell")
        for half in bounds:
            expect(heights([p], half)[0] > 0, "certificate: a point is not in its cell")
        expect(proved_location(proof, *solids[solid], p) == "outside", "certificate: a cell is not outside")
    expect(not left, "certificate: the tree ends too early")


def expect_common_point(claim, solids, inside):
    p = triple(claim, "point")
    for solid, name in zip(solids, ("in_a", "in_b")):
        proof = claim.proofs(name)
        expect(len(proof) == 1, "certificate: one proof for each solid")
        location = proved_location(proof[0], *solid, p)
        if inside:
            expect(location == "inside", "certificate: the point is not inside of both")
        else:
            expect(location != "outside", "certificate: the point is not in both")


def proved_step(claim, solids):
    vertex, proof = claim.list("vertex"), claim.proofs("vertices")
    if vertex:
        expect(len(vertex) == 2 and len(proof) == 1, "certificate: one vertex and its proof")
        solid = index(vertex[0], 2)
        i = index(vertex[1], len(solids[solid][0]))
        expect(i in named(solids[solid]), "certificate: no face names the vertex")
        location = proved_location(proof[0], *solids[1 - solid], solids[solid][0][i])
        expect(location == "inside", "certificate: the vertex is not inside")
        return "vertex_inside"
    points = [(solids[1 - solid], solids[solid][0][i]) for solid in (0, 1) for i in named(solids[solid])]
    expect(len(proof) == len(points), "certificate: a proof for each vertex")
    for (other, p), one in zip(points, proof):
        expect(proved_location(one, *other, p) != "inside", "certificate: a vertex is inside")
    return "edge_against_face"


def proved(claim, solids):
    (low_a, high_a), (low_b, high_b) = map(box_around, solids)
    if claim.kind() == "separating_axis":
        claim.facts("axis", "value")
        axis = index(claim.single("axis"), 3)
        value = claim.single("value")
        between = high_a[axis] < value < low_b[axis] or high_b[axis] < value < low_a[axis]
        expect(between, "certificate: the value is not between the boxes")
        return "disjoint", "bounding_volumes"
    disjoint, touching = claim.kind() == "partition", claim.kind() == "touching"
    expect(disjoint or touching or claim.kind() == "common_interior_point", WRONG_KIND)
    common, partition, step = ("point", "in_a", "in_b"), ("tree", "planes", "points", "outside"), ("vertex", "vertices")
    claim.facts(*(partition if disjoint else common + partition + step if touching else common + step))
    apart = any(high_a[k] < low_b[k] or high_b[k] < low_a[k] for k in range(3))
    expect(not apart, "certificate: the boxes do not meet")
    if not disjoint:
        expect_common_point(claim, solids, not touching)
    if disjoint or touching:
        expect_partition(claim, solids, disjoint)
    if disjoint:
        return "disjoint", "edge_against_face"
    return "touching" if touching else "overlapping", proved_step(claim, solids)


def check_polyhedron_polyhedron(claim):
    claim.inputs("a", "b")
    solids = []
    for name in ("a", "b"):
        solids.append(mesh(claim.input[name], name))
        expect_even(solids[-1][1], name)
    claim.answers("relation", "decided_by")
    relation, step = proved(claim, solids)
    expect(claim.word("relation") == relation, "truth: relation is wrong")
    expect(claim.word("decided_by") == step, "truth: decided_by is wrong")
