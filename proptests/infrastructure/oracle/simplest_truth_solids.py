# SPDX-License-Identifier: Apache-2.0
"""The second truths of the distance of two convex solids, or of two triangles, and of the overlap of two solids, for
simplest_truth.py."""
from fractions import Fraction
from itertools import combinations
from math import lcm

import simplest_truth_sweeps
from simplest_truth_mixed import ball, capsule, contact
from simplest_truth_polyhedra import cross
from simplest_truth_reading import Root, by_sign, dot, minus, number, point, triangles


def solved(matrix, right):
    """Linear equations by elimination; nothing where they are dependent."""
    rows = [list(map(Fraction, row)) + [Fraction(last)] for row, last in zip(matrix, right)]
    for k in range(len(rows)):
        pivot = next((i for i in range(k, len(rows)) if rows[i][k]), None)
        if pivot is None:
            return None
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i, row in enumerate(rows):
            if i != k:
                factor = row[k] / rows[k][k]
                rows[i] = [x - factor * y for x, y in zip(row, rows[k])]
    return [row[-1] / row[k] for k, row in enumerate(rows)]


def plus(p, *terms):
    return tuple(x + sum(t * v[k] for t, v in terms) for k, x in enumerate(p))


def foot(points):
    """Returns the point of the plane through the points that is nearest to 0, if it is between them."""
    edges = [minus(p, points[0]) for p in points[1:]]
    weights = solved([[dot(v, w) for w in edges] for v in edges], [-dot(v, points[0]) for v in edges])
    if weights is None or min([*weights, 1 - sum(weights)]) < 0:
        return []
    return [plus(points[0], *zip(weights, edges))]


def shortest(ways):
    """Gilbert, Johnson and Keerthi: the least on some of the ways, until none of all is beyond it."""
    some = ways[:1]
    while True:
        faces = [(x, face) for n in (1, 2, 3, 4) for face in combinations(some, n) for x in foot(face)]
        least, face = min(faces, key=lambda found: dot(found[0], found[0]))
        beyond = min(ways, key=lambda way: dot(way, least))
        if dot(beyond, least) >= dot(least, least):
            return least
        some = [*face, beyond]


def planes(points, faces):
    """Inside where normal . p <= offset."""
    found = []
    for i, j, k in faces:
        normal = cross(minus(points[j], points[i]), minus(points[k], points[i]))
        heights = [dot(normal, minus(p, points[i])) for p in points]
        found.append((normal if max(heights) == 0 else minus((0, 0, 0), normal), points[i]))
    return [(normal, dot(normal, p)) for normal, p in found]


def first_in(level, sides, start):
    """The point of a plane between others that is nearest to the start: its foot on that one alone, or with one or two
    more."""
    feet = []
    for chosen in ([level, *more] for n in range(3) for more in combinations(sides, n)):
        steps = solved([[dot(m, n) for n, _ in chosen] for m, _ in chosen], [d - dot(n, start) for n, d in chosen])
        if steps is not None:
            feet.append(plus(start, *zip(steps, (n for n, _ in chosen))))
    within = [p for p in feet if all(dot(n, p) <= d for n, d in sides)]
    return min(within, key=lambda p: dot(minus(p, start), minus(p, start)))


def truth_convex_distance(q):
    """They meet, and have the margin, as in a sweep of velocity 0. The points on a are those between its planes and
    between b's, moved by the shortest displacement."""
    hit, margin = simplest_truth_sweeps.truth_swept_convex_polyhedra({**q, "velocity": [0, 0, 0]})
    if hit["relation"] == "hit":
        return {"relation": "meeting", "squared_distance": "0", "distance": "0"}, margin
    a, b = ([point(v) for v in q[name]["vertices"]] for name in "ab")
    way = shortest([minus(v, w) for v in a for w in b])
    moved = [plus(w, (1, way)) for w in b]
    level = (way, min(dot(way, v) for v in a))
    x = first_in(level, sorted({*planes(a, triangles(q["a"])), *planes(moved, triangles(q["b"]))}), a[0])
    square = dot(way, way)
    return {"relation": "apart", "on_a": [str(n) for n in x], "on_b": [str(n) for n in minus(x, way)],
            "squared_distance": str(square), "distance": Root(square, 1)}, margin


def level_sides(corners, way):
    """The half-spaces that bound, in their plane across the way, a triangle or a segment; of one point, none."""
    edges = [minus(q, p) for p, q in combinations(corners, 2) if p != q]
    if edges and not any(cross(edges[0], edges[-1])):
        edges = [max(edges, key=lambda edge: dot(edge, edge))]
    ways = [cross(way, edge) for edge in edges] + (edges if len(edges) == 1 else [])
    return {(n, max(dot(n, p) for p in corners)) for across in ways for n in (across, minus((0, 0, 0), across))}


def squared_depth(ways):
    """How far the origin is from the planes that have all points of a hull, which holds it, on one side."""
    squares = []
    for p, q, r in combinations(ways, 3):
        normal = cross(minus(q, p), minus(r, p))
        heights = [dot(normal, minus(x, p)) for x in ways]
        if any(normal) and (min(heights) == 0 or max(heights) == 0):
            squares.append(Fraction(dot(normal, p) ** 2, dot(normal, normal)))
    return min(squares, default=Fraction(0))


def truth_triangle_triangle_distance(q):
    """As truth_convex_distance, in integers, and of the corners alone that are as far along the shortest displacement;
    the margin is the squared distance, or how deep the origin is in the difference."""
    a, b = ([point(p) for p in q[name]] for name in "ab")
    scale = lcm(*(x.denominator for p in a + b for x in p))
    a, b = ([tuple(int(x * scale) for x in p) for p in corners] for corners in (a, b))
    ways = [minus(p, r) for p in a for r in b]
    way = shortest(ways)
    square = dot(way, way) / Fraction(scale) ** 2
    if not square:
        return {"relation": "meeting", "squared_distance": "0", "distance": "0"}, squared_depth(ways) / scale**2
    lowest = min(dot(way, p) for p in a)
    of_a = [p for p in a if dot(way, p) == lowest]
    of_b = [p for p in (plus(r, (1, way)) for r in b) if dot(way, p) == lowest]
    single = [part[0] for part in (of_a, of_b) if len(set(part)) == 1]
    x = single[0] if single else first_in((way, lowest), sorted(level_sides(of_a, way) | level_sides(of_b, way)), a[0])
    on_a, on_b = ([str(Fraction(n) / scale) for n in p] for p in (x, minus(x, way)))
    return {"relation": "apart", "on_a": on_a, "on_b": on_b, "squared_distance": str(square),
            "distance": Root(square, 1)}, square


def contact_with_convex(ends, radius, mesh):
    way = shortest([minus(point(v), p) for v in mesh["vertices"] for p in ends])
    return contact(dot(way, way), [radius])


def truth_sphere_convex(q):
    center, radius = ball(q["sphere"])
    return contact_with_convex([center], radius, q["mesh"])


def truth_capsule_convex(q):
    return contact_with_convex(*capsule(q["capsule"]), q["mesh"])


class PlusRoot(Root):
    """A rational number and a square root with a sign."""

    def __init__(self, rational, square, sign):
        super().__init__(square, sign)
        self.rational = rational

    def __eq__(self, said):
        if "sqrt(" not in said:
            return Root.__eq__(self, str(Fraction(said) - self.rational))
        place = max(said.rfind("+"), said.rfind("-"))
        before, root = (said[:place], said[place:].removeprefix("+")) if place > 0 else ("0", said)
        return Fraction(before) == self.rational and Root.__eq__(self, root)


def directions_of(vectors):
    """Without their multiples."""
    found = {}
    for v in filter(any, vectors):
        first = next(x for x in v if x)
        found.setdefault(tuple(Fraction(x, first) for x in v), v)
    return list(found.values())


def level(points, direction):
    heights = [dot(direction, p) for p in points]
    return [i for i, height in enumerate(heights) if height == max(heights)], max(heights)


def spans(points, indices):
    return [minus(points[i], points[indices[0]]) for i in indices]


def dimension(vectors):
    """Returns that of what they span, up to 2."""
    some = next((v for v in vectors if any(v)), None)
    if some is None:
        return 0
    return 2 if any(any(cross(some, v)) for v in vectors) else 1


def edges_of(mesh):
    """Pairs of vertices; all of a mesh without faces."""
    if not mesh["faces"]:
        return list(combinations(range(len(mesh["vertices"])), 2))
    return [edge for face in triangles(mesh) for edge in zip(face, face[1:] + face[:1])]


def last_across(vectors):
    """Returns the last direction, in lexicographic order, of all at a right angle to these, which lie in a plane: the
    part of an axis, less what it has along them."""
    basis = []
    for v in [*vectors, (1, 0, 0), (0, 1, 0), (0, 0, 1)]:
        part = plus(v, *((-Fraction(dot(v, w)) / dot(w, w), w) for w in basis))
        if any(part) and len(basis) < dimension(vectors):
            basis.append(part)
        elif any(part):
            return part


def truth_penetration(q):
    """Every direction at a right angle to two edges, and the opposite one. Where it is the least, the farthest vertices
    must span a plane: otherwise it is no face's. Where all differences lie in a plane, no such direction tells whether
    the cores meet, but the shortest way does."""
    a, b = ([point(v) for v in q[name]["vertices"]] for name in "ab")
    unit = lcm(*(x.denominator for p in a + b for x in p))
    a, b = ([tuple(int(x * unit) for x in p) for p in points] for points in (a, b))
    radii = number(q["radius_a"]) + number(q["radius_b"])
    edges = directions_of(minus(points[j], points[i]) for points, name in ((a, "a"), (b, "b"))
                          for i, j in edges_of(q[name]))
    found = []
    normals = directions_of(cross(v, w) for v, w in combinations(edges, 2))
    if len(normals) < 2:
        normals = []
        if not any(shortest([minus(v, w) for v in a for w in b])):
            found = [(0, list(range(len(a))), list(range(len(b))), 0, last_across(edges))]
    for normal in normals:
        for side in (normal, tuple(-x for x in normal)):
            (of_a, back), (of_b, front) = level(a, tuple(-x for x in side)), level(b, side)
            height = front + back
            if height < 0:
                found = []
                break
            flat = height > 0 or dimension(spans(a, of_a) + spans(b, of_b)) == 2
            found += flat * [(Fraction(height**2, dot(side, side)), of_a, of_b, height, side)]
        else:
            continue
        break
    if found:
        _, of_a, of_b, height, side = min(found)
    else:
        side = shortest([minus(v, w) for v in a for w in b])
        height, of_a, of_b = -dot(side, side), level(a, tuple(-x for x in side))[0], level(b, side)[0]
    square, height = dot(side, side), Fraction(height) / unit
    of_cores, sign = height**2 / square, by_sign(height, -1, 1, 1)
    depth = radii**2 + sign * of_cores
    parts = [("vertex", "edge", "face")[dimension(spans(p, of))] for p, of in ((a, of_a), (b, of_b))]
    return {"contact": by_sign(depth, "disjoint", "touching", "overlapping"), "depth": PlusRoot(radii, of_cores, sign),
            "direction": [Root(Fraction(n**2) / square, by_sign(n, -1, 1, 1)) for n in side],
            "translation": [PlusRoot(n * height / square, Fraction(n**2) / square * radii**2, by_sign(n, -1, 1, 1))
                            for n in side],
            "feature": dict(zip("ab", parts))}, abs(depth)
