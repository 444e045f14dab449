# SPDX-License-Identifier: Apache-2.0
"""The second truth of polygons: all pairs of edges, ears cut off, triangles clipped."""
from fractions import Fraction

from simplest_truth_reading import at, cross, cut, in_common, minus, point, squared_distance

# Operations of the chapter that have no second truth, and why.
WITHOUT = {
    "interior_angles": "its answers are irrational; the checkers of certificates enclose them by series of their own",
    "triangulate_polygon": "many answers are right; certify_triangulation.py proves each in fractions",
    "convex_partition": "many answers are right; certify_triangulation.py proves each in fractions",
}


def vertices(positions):
    """A last position that repeats the first is none, once."""
    ring = [point(p) for p in positions]
    return ring[:-1] if ring[0] == ring[-1] else ring


def turn(ring, i):
    """To which side the ring turns at vertex i: > 0 is left."""
    a, b, c = ring[i - 1], ring[i], ring[(i + 1) % len(ring)]
    return cross(minus(b, a), minus(c, b))


def crosses_itself(ring):
    """Returns whether two edges, which are no points, have more in common than the one vertex that neighbours share."""
    edges = [(p, ring[(i + 1) % len(ring)]) for i, p in enumerate(ring)]
    for j, (c, d) in enumerate(edges):
        for i, (a, b) in enumerate(edges[:j]):
            shared = [p for p, joined in ((c, j == i + 1), (a, (j + 1) % len(ring) == i)) if joined]
            interval = in_common(a, minus(b, a), Fraction(1), (c, d))
            if interval and not all(at(a, t, minus(b, a)) in shared for t in interval):
                return True
    return False


def truth_polygon_convexity(q):
    ring = vertices(q["polygon"])
    turns = [turn(ring, i) for i in range(len(ring))]
    flat = all(cross(minus(p, ring[0]), minus(r, ring[0])) == 0 for p in ring for r in ring)
    degenerate = flat or any(p == ring[i - 1] for i, p in enumerate(ring))
    if degenerate or crosses_itself(ring):
        return {"class": "degenerate" if degenerate else "not_simple", "strict": False, "orientation": "none"}, None
    convex = min(turns) >= 0 or max(turns) <= 0
    lowest = turns[min(range(len(ring)), key=lambda i: ring[i])]  # the ring turns there as it turns as a whole
    return {"class": "convex" if convex else "concave", "strict": convex and 0 not in turns,
            "orientation": "ccw" if lowest > 0 else "cw"}, None


def doubled_area(ring):
    return sum((cross(p, q) for p, q in zip(ring, ring[1:] + ring[:1])), Fraction(0))


def side(p, q, r):
    return cross(minus(q, p), minus(r, p))


def triangles(ring):
    """Ears cut off one by one; flat vertices are left out."""
    ring = ring if doubled_area(ring) > 0 else ring[::-1]
    while len(ring) > 2:
        for i, q in enumerate(ring):
            p, r = ring[i - 1], ring[(i + 1) % len(ring)]
            others = [v for v in ring if v not in (p, q, r)]
            inside = any(side(p, q, v) >= 0 and side(q, r, v) >= 0 and side(r, p, v) >= 0 for v in others)
            if side(p, q, r) == 0 or (side(p, q, r) > 0 and not inside):
                if side(p, q, r) > 0:
                    yield [p, q, r]
                ring = ring[:i] + ring[i + 1 :]
                break


def clipped(ring, p, q):
    """The part of a convex ring to the left of p -> q."""
    kept = []
    for v, w in zip(ring, ring[1:] + ring[:1]):
        before, after = side(p, q, v), side(p, q, w)
        if before >= 0:
            kept.append(v)
        if before * after < 0:
            kept.append(at(v, before / (before - after), minus(w, v)))
    return kept


def overlap(s, t):
    for i in range(3):
        s = clipped(s, t[i], t[(i + 1) % 3])
    return len(s) > 2 and doubled_area(s) > 0


def overlap_area(one, other):
    """Twice the area that two simple rings have in common."""
    total = Fraction(0)
    for s in triangles(one):
        for t in triangles(other):
            part = s
            for i in range(3):
                part = clipped(part, t[i], t[(i + 1) % 3])
            total += doubled_area(part)
    return total


def rings_of(region):
    """Each with its share of the area: the outer ring adds, holes subtract."""
    return [(1, vertices(region["outer"]))] + [(-1, vertices(hole)) for hole in region["holes"]]


def truth_region_region(given):
    """The areas of the rings' overlaps, those of a hole with a ring subtracted, those of two holes added."""
    a, b = (rings_of(given[name]) for name in "ab")
    margin = min(squared_distance(v, p, minus(q, p), Fraction(1)) for one, other in ((a, b), (b, a)) for _, ring in one
                 for v in ring for _, far in other for p, q in zip(far, far[1:] + far[:1]))
    if sum(s * t * overlap_area(one, other) for s, one in a for t, other in b) > 0:
        return {"contact": "overlapping"}, margin
    return {"contact": "touching" if margin == 0 else "disjoint"}, margin


def truth_polygon_polygon(given):
    """The triangles of one clipped to those of the other; without a common area only a vertex on an edge can touch."""
    a, b = (vertices(given[name]) for name in "ab")
    margin = min(squared_distance(v, p, minus(q, p), Fraction(1))
                 for one, other in ((a, b), (b, a)) for v in one for p, q in zip(other, other[1:] + other[:1]))
    if any(overlap(s, t) for s in triangles(a) for t in triangles(b)):
        return {"contact": "overlapping"}, margin
    return {"contact": "touching" if margin == 0 else "disjoint"}, margin


def truth_point_in_polygon(q):
    """By a ray upwards: it passes the edges that have one end strictly to the right of it."""
    ring, p = [minus(point(vertex), point(q["point"])) for vertex in q["polygon"]], (Fraction(0), Fraction(0))
    edges = list(zip(ring, ring[1:] + ring[:1]))
    margin = min(squared_distance(p, a, minus(b, a), Fraction(1)) for a, b in edges)
    inside = sum((a[0] > 0) != (b[0] > 0) and (cross(a, b) > 0) == (a[0] > 0) for a, b in edges) % 2 == 1
    return {"location": "boundary" if margin == 0 else "inside" if inside else "outside"}, margin


def truth_point_in_region(q):
    """Ring by ring: inside the outer one and no hole, or on any of them."""
    found = [truth_point_in_polygon({"polygon": ring, "point": q["point"]})
             for ring in [q["region"]["outer"], *q["region"]["holes"]]]
    (outer, *holes), margin = [truth["location"] for truth, _ in found], min(margin for _, margin in found)
    inside = outer == "inside" and all(location == "outside" for location in holes)
    return {"location": "boundary" if margin == 0 else "inside" if inside else "outside"}, margin


def truth_point_in_convex_polygon(q):
    return truth_point_in_polygon(q)
