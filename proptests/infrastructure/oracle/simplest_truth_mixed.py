# SPDX-License-Identifier: Apache-2.0
"""The second truths of shapes of two chapters, for simplest_truth.py."""
import itertools
from fractions import Fraction

from simplest_truth_polyhedra import cross, truth_point_in_polyhedron
from simplest_truth_reading import Root, dot, minus, named_triangles, number, point
from simplest_truth_volumes import contact_with_obb, gap_to_box, way_from_box


def truth_sphere_plane(q):
    """The least height that the ball reaches, and the greatest of a point of it, have roots: heights are compared by
    squares with signs. Margin: how far the square of the height is from that of the radius, and, where they meet, the
    square of the radius."""
    normal, square_of_radius = point(q["plane"]["normal"]), number(q["sphere"]["radius"]) ** 2
    height = dot(normal, point(q["sphere"]["center"])) + number(q["plane"]["offset"])
    gap = height * abs(height) / dot(normal, normal) - square_of_radius
    least = gap if gap > 0 else min(-gap, square_of_radius)
    contact = "disjoint" if gap > 0 else "overlapping" if least > 0 else "touching"
    return {"contact": contact}, least


def truth_aabb_plane(q):
    """The height of the center, and how far the box rises and falls from it. Margin: the square of the least height;
    where they meet, of the least width too."""
    normal, low, high = point(q["plane"]["normal"]), point(q["aabb"]["min"]), point(q["aabb"]["max"])
    half = [(b - a) / 2 for a, b in zip(low, high)]
    center = [a + h for a, h in zip(low, half)]
    least = dot(normal, center) + number(q["plane"]["offset"]) - dot([abs(n) for n in normal], half)
    margin = least**2 / dot(normal, normal)
    if least > 0:
        return {"contact": "disjoint"}, margin
    margin = min(margin, 4 * min(half) ** 2)
    return {"contact": "overlapping" if margin else "touching"}, margin


def truth_capsule_plane(q):
    """That of the ball around the lower end."""
    lower = min(q["capsule"]["segment"], key=lambda end: dot(point(q["plane"]["normal"]), point(end)))
    return truth_sphere_plane({"sphere": {"center": lower, "radius": q["capsule"]["radius"]}, "plane": q["plane"]})


def truth_obb_plane(q):
    """The height of the center, and how far the half axes fall from it. Margin: the square of the least height."""
    normal, axes = point(q["plane"]["normal"]), map(point, q["obb"]["half_axes"])
    least = dot(normal, point(q["obb"]["center"])) + number(q["plane"]["offset"])
    least -= sum(abs(dot(normal, axis)) for axis in axes)
    contact = "disjoint" if least > 0 else "overlapping" if least < 0 else "touching"
    return {"contact": contact}, least**2 / dot(normal, normal)


def clamped(p, a, b):
    """The nearest point of a segment: the vertex of a parabola in t, moved into [0, 1]."""
    v = minus(b, a)
    length = dot(v, v)
    t = min(max(dot(minus(p, a), v) / length, Fraction(0)), Fraction(1)) if length else Fraction(0)
    return tuple(x + t * y for x, y in zip(a, v))


def square(p, q):
    return dot(minus(p, q), minus(p, q))


def closest(p, candidates):
    x = min(candidates, key=lambda candidate: square(p, candidate))
    found = square(p, x)
    return {"point": [str(n) for n in x], "squared_distance": str(found), "distance": Root(found, 1)}, None


def truth_closest_point_on_segment(q):
    p = point(q["point"])
    return closest(p, [clamped(p, *map(point, q["segment"]))])


def solved(matrix, right):
    """Two linear equations, by Cramer; nothing where they are dependent."""
    (a, b), (c, d) = matrix
    whole = a * d - b * c
    return ((right[0] * d - b * right[1]) / whole, (a * right[1] - right[0] * c) / whole) if whole else None


def foot_on_face(p, a, b, c):
    """Returns [the foot] of the perpendicular if it is in the triangle, else []."""
    v, w, way = minus(b, a), minus(c, a), minus(p, a)
    weights = solved(((dot(v, v), dot(v, w)), (dot(v, w), dot(w, w))), (dot(way, v), dot(way, w)))
    if weights is None or min(*weights, 1 - sum(weights)) < 0:
        return []
    return [tuple(x + weights[0] * y + weights[1] * z for x, y, z in zip(a, v, w))]


def truth_closest_point_on_triangle(q):
    p, (a, b, c) = point(q["point"]), map(point, q["triangle"])
    return closest(p, [clamped(p, a, b), clamped(p, b, c), clamped(p, c, a), *foot_on_face(p, a, b, c)])


def place_in(ring, x):
    """Returns whether a point of a face is a corner of it, on an edge or inside."""
    on_edge = any(clamped(x, a, b) == x for a, b in zip(ring, ring[1:] + ring[:1]))
    return "vertex" if x in ring else "edge" if on_edge else "inside"


def truth_point_mesh_distance(q):
    """The nearest of all feet on edges and faces, the least of these by coordinates, and then by face. Location and
    margin are as in point_in_polyhedron; a triangle whose box is farther away than that is left out."""
    p, vertices = point(q["point"]), [point(v) for v in q["mesh"]["vertices"]]
    location, margin = truth_point_in_polyhedron(q)
    found = []
    for face, corners in named_triangles(q["mesh"]):
        a, b, c = (vertices[k] for k in corners)
        if sum(max(0, min(on_axis) - x, x - max(on_axis)) ** 2 for x, *on_axis in zip(p, a, b, c)) > margin:
            continue
        feet = [clamped(p, a, b), clamped(p, b, c), clamped(p, c, a), *foot_on_face(p, a, b, c)]
        found += [(square(p, x), x, face) for x in feet]
    least, x, face = min(found)
    part = place_in([vertices[k] for k in q["mesh"]["faces"][face]], x)
    return {**location, "nearest": {"point": [str(n) for n in x], "face": face, "part": part},
            "squared_distance": str(least), "distance": Root(least, 1),
            "signed_distance": Root(least, -1 if location["location"] == "inside" else 1)}, margin


def truth_closest_point_on_obb(q):
    p, box = point(q["point"]), q["obb"]
    return closest(p, [minus(p, way_from_box(p, [], point(box["center"]), list(map(point, box["half_axes"]))))])


def nearest_pairs(a, b):
    """Pairs among which the nearest are: an end of one and its nearest point on the other, and the feet of the common
    perpendicular where both are within."""
    pairs = [(p, clamped(p, *b)) for p in a] + [(clamped(p, *a), p) for p in b]
    v, w, way = minus(a[1], a[0]), minus(b[1], b[0]), minus(b[0], a[0])
    feet = solved(((dot(v, v), -dot(v, w)), (dot(v, w), -dot(w, w))), (dot(way, v), dot(way, w)))
    if feet and 0 <= min(feet) and max(feet) <= 1:
        pairs.append(tuple(tuple(x + t * y for x, y in zip(s, way)) for t, s, way in zip(feet, (a[0], b[0]), (v, w))))
    return pairs


def truth_segment_segment_distance(q):
    """Takes among several pairs the one whose point on a is nearest to the beginning of a."""
    a, b = (tuple(map(point, q[name])) for name in "ab")
    x, y = min(nearest_pairs(a, b), key=lambda pair: (square(*pair), square(pair[0], a[0])))
    return {"on_a": [str(n) for n in x], "on_b": [str(n) for n in y], "squared_distance": str(square(x, y)),
            "distance": Root(square(x, y), 1)}, None


def contact(distance, radii):
    """Margin: how far the square of the distance is from that of the sum of the radii; where they meet, how far it may
    shrink."""
    reach = sum(radii)
    if distance > reach**2:
        return {"contact": "disjoint"}, distance - reach**2
    margin = min(reach**2 - distance, *(reach**2 - (reach - radius) ** 2 for radius in radii))
    return {"contact": "overlapping" if margin else "touching"}, margin


def ball(solid):
    return point(solid["center"]), number(solid["radius"])


def truth_sphere_triangle(q):
    (p, radius), (a, b, c) = ball(q["sphere"]), map(point, q["triangle"])
    near = [clamped(p, a, b), clamped(p, b, c), clamped(p, c, a), *foot_on_face(p, a, b, c)]
    return contact(min(square(p, x) for x in near), [radius])


def capsule(solid):
    return tuple(map(point, solid["segment"])), number(solid["radius"])


def truth_sphere_capsule(q):
    (p, r), (segment, s) = ball(q["sphere"]), capsule(q["capsule"])
    return contact(square(p, clamped(p, *segment)), [r, s])


def truth_capsule_capsule(q):
    (a, r), (b, s) = capsule(q["a"]), capsule(q["b"])
    return contact(min(square(*pair) for pair in nearest_pairs(a, b)), [r, s])


def truth_capsule_triangle(q):
    """Among the nearest points are an end of the segment and its foot on the face, or a point of an edge, or the point
    where the segment passes through the face, which is its own foot."""
    ((p, r), radius), (a, b, c) = capsule(q["capsule"]), map(point, q["triangle"])
    normal = cross(minus(b, a), minus(c, a))
    from_p, from_r = dot(normal, minus(p, a)), dot(normal, minus(r, a))
    on_segment = [p, r]
    if from_p * from_r < 0:
        on_segment.append(tuple(x + from_p / (from_p - from_r) * (y - x) for x, y in zip(p, r)))
    pairs = [(x, y) for x in on_segment for y in foot_on_face(x, a, b, c)]
    pairs += [pair for edge in ((a, b), (b, c), (c, a)) for pair in nearest_pairs((p, r), edge)]
    return contact(min(square(*pair) for pair in pairs), [radius])


def truth_capsule_obb(q):
    segment, radius = capsule(q["capsule"])
    middle, half = halves(*segment)
    return contact_with_obb(middle, [half], q["obb"], radius)


def halves(a, b):
    return tuple((x + y) / 2 for x, y in zip(a, b)), tuple((y - x) / 2 for x, y in zip(a, b))


def truth_capsule_aabb(q):
    """Margin: as of other contacts; where they meet, also the square of the least width."""
    segment, radius = capsule(q["capsule"])
    (middle, half), (center, sizes) = halves(*segment), halves(point(q["aabb"]["min"]), point(q["aabb"]["max"]))
    axes = [tuple(size if k == axis else Fraction(0) for k in range(3)) for axis, size in enumerate(sizes)]
    truth, margin = contact(gap_to_box(middle, [half], center, axes), [radius])
    if truth["contact"] == "disjoint":
        return truth, margin
    margin = min(margin, 4 * min(sizes) ** 2)
    return {"contact": "overlapping" if margin else "touching"}, margin


def clipped(polygon, height):
    """The part of a convex polygon that is not below 0: its vertices there, and the points of edges that cross."""
    kept = []
    for p, q in zip(polygon, polygon[1:] + polygon[:1]):
        before, after = height(p), height(q)
        if before >= 0:
            kept.append(p)
        if before * after < 0:
            kept.append(tuple(x + before / (before - after) * (y - x) for x, y in zip(p, q)))
    return kept


def greatest_depth(corners, heights):
    """How far a point of a triangle can be above 0 in all heights: it is a corner, or a point of an edge where two of
    them are equal, or one where three are."""
    a, b, c = corners
    found = list(corners)
    for f, g in itertools.combinations(heights, 2):
        for p, q in ((a, b), (b, c), (c, a)):
            before, after = f(p) - g(p), f(q) - g(q)
            if before * after < 0:
                found.append(tuple(x + before / (before - after) * (y - x) for x, y in zip(p, q)))
    for f, g, h in itertools.combinations(heights, 3):
        gaps = [[one(p) - other(p) for p in corners] for one, other in ((f, g), (f, h))]
        weights = solved([(of_b - of_a, of_c - of_a) for of_a, of_b, of_c in gaps], [-of_a for of_a, *_ in gaps])
        if weights and min(*weights, 1 - sum(weights)) >= 0:
            found.append(tuple(x + weights[0] * (y - x) + weights[1] * (z - x) for x, y, z in zip(a, b, c)))
    return max(min(height(p) for height in heights) for p in found)


def contact_by_cuts(corners, heights):
    """Cuts the triangle with a solid, face by face; the mean of the vertices that remain is inside if any of it is."""
    rest = corners
    for height in heights:
        rest = clipped(rest, height)
    mean = [sum(along) / len(rest) for along in zip(*rest)]
    inside = rest and all(height(mean) > 0 for height in heights)
    return {"contact": "overlapping" if inside else "touching" if rest else "disjoint"}


def truth_triangle_aabb(q):
    """Margin: how deep a point of the triangle can be within all faces."""
    corners, low, high = list(map(point, q["triangle"])), point(q["aabb"]["min"]), point(q["aabb"]["max"])
    heights = [lambda p, k=k: p[k] - low[k] for k in range(3)] + [lambda p, k=k: high[k] - p[k] for k in range(3)]
    return contact_by_cuts(corners, heights), abs(greatest_depth(corners, heights))


def truth_triangle_obb(q):
    """Depths within the faces in units of that of the center, so by the coefficients of the half axes. Margin: the
    greatest depth of a point, times the center's least, squared."""
    corners, center = list(map(point, q["triangle"])), point(q["obb"]["center"])
    u, v, w = map(point, q["obb"]["half_axes"])
    normals, volume = [cross(u, v), cross(v, w), cross(w, u)], dot(u, cross(v, w))
    heights = [lambda p, n=n, side=side: 1 - side * dot(n, minus(p, center)) / volume
               for n in normals for side in (1, -1)]
    least = min(volume**2 / dot(n, n) for n in normals)
    return contact_by_cuts(corners, heights), greatest_depth(corners, heights) ** 2 * least
