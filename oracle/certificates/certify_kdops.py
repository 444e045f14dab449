# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for volumes of intervals around points, boxes and k-DOPs, as in check_kdops.cpp."""

from certify_reading import exact_pair, exact_value, expect, number, only, point
from certify_space import dot, point_in_space, points_in_space

WRONG_VALUE = "certificate: the value of N . P is wrong"


def points(value, what):
    """Reads points of one dimension, two or three; there is at least one."""
    expect(isinstance(value, list) and value, what + ": at least 1 point")
    found = []
    for i, written in enumerate(value):
        each = f"{what}[{i}]"
        expect(isinstance(written, list) and len(written) in (2, 3), each + ": a list of two or three")
        found.append([number(coordinate, f"{each}[{axis}]") for axis, coordinate in enumerate(written)])
        expect(len(found[-1]) == len(found[0]), each + ": as many coordinates as the first")
    return found


def place(index, size, of_what):
    expect(index.denominator == 1 and 0 <= index < size, f"certificate: no {of_what} has this place")
    return int(index)


def exact_values(value, what, size):
    expect(isinstance(value, list) and len(value) == size, f"{what}: a list of {'two' if size == 2 else 'three'}")
    return [exact_value(each, f"{what}[{i}]") for i, each in enumerate(value)]


def check_aabb_of_points(claim):
    claim.inputs("points")
    everything = points(claim.input["points"], "points")
    axes = len(everything[0])
    claim.answers("aabb")
    box = claim.truth["aabb"]
    only(box, "truth.aabb", ("min", "max"))
    low = exact_values(box["min"], "truth.aabb.min", axes)
    high = exact_values(box["max"], "truth.aabb.max", axes)
    claim.expect_kind("extreme_points"), claim.facts("least", "greatest")
    least, greatest = claim.list("least"), claim.list("greatest")
    expect(len(least) == len(greatest) == axes, "certificate: two places for each axis")
    for k in range(axes):
        expect(everything[place(least[k], len(everything), "point")][k] == low[k]
               and everything[place(greatest[k], len(everything), "point")][k] == high[k],
               "certificate: the point has another coordinate")
        expect(all(low[k] <= p[k] <= high[k] for p in everything), "truth: a point is not in the box")


def normal(value, what):
    found = point_in_space(value, what)
    expect(found != (0, 0, 0), what + ": nonzero normal")
    return found


def kdop(value, what):
    """(normals, slabs), a slab being (min, max)."""
    only(value, what, ("normals", "slabs"))
    written, slabs = value["normals"], value["slabs"]
    expect(isinstance(written, list) and written, what + ".normals: at least 1 normal")
    expect(isinstance(slabs, list) and len(slabs) == len(written), what + ".slabs: as many slabs as normals")
    found = []
    for i, (one, slab) in enumerate(zip(written, slabs)):
        n, (low, high) = normal(one, f"{what}.normals[{i}]"), point(slab, f"{what}.slabs[{i}]")
        expect(low <= high, f"{what}.slabs[{i}][1]: min <= max")
        found.append((n, (low, high)))
    return [n for n, _ in found], [slab for _, slab in found]


def check_point_in_kdop(claim):
    claim.inputs("kdop", "point")
    normals, slabs = kdop(claim.input["kdop"], "kdop")
    p = point_in_space(claim.input["point"], "point")
    claim.answers("location")
    location = claim.word("location")
    values = [dot(n, p) for n in normals]
    if location == "inside":
        claim.expect_kind("values"), claim.facts("values")
        expect(claim.list("values") == values, WRONG_VALUE)
        inside = all(low < value < high for value, (low, high) in zip(values, slabs))
        expect(inside, "truth: the point is not inside a slab")
        return
    expect(location in ("boundary", "outside"), "truth: location is wrong")
    claim.expect_kind("beyond_slab" if location == "outside" else "end_of_slab"), claim.facts("slab", "value")
    i = place(claim.single("slab"), len(values), "slab")
    expect(claim.single("value") == values[i], WRONG_VALUE)
    if location == "outside":
        expect(not slabs[i][0] <= values[i] <= slabs[i][1], "certificate: the slab holds the point")
        return
    expect(values[i] in slabs[i], "certificate: the slab does not end there")
    held = all(low <= value <= high for value, (low, high) in zip(values, slabs))
    expect(held, "truth: a slab excludes the point")


def check_kdop_kdop(claim):
    claim.inputs("a", "b")
    (normals, a), (others, b) = kdop(claim.input["a"], "a"), kdop(claim.input["b"], "b")
    expect(len(others) == len(normals), "b.normals: the same normals as a")
    for i, (n, m) in enumerate(zip(normals, others)):
        expect(n == m, f"b.normals[{i}]: the same normal as in a")
    claim.answers("contact")
    contact = claim.word("contact")
    if contact == "disjoint":
        claim.expect_kind("separating_slab"), claim.facts("slab", "value")
        i, value = place(claim.single("slab"), len(a), "slab"), claim.single("value")
        apart = a[i][1] < value < b[i][0] or b[i][1] < value < a[i][0]
        expect(apart, "certificate: the slabs are not apart there")
        return
    expect(contact in ("touching", "overlapping"), "truth: contact is wrong")
    touching = contact == "touching"
    claim.expect_kind("touching_slab" if touching else "common_values")
    claim.facts(*(("slab", "values") if touching else ("values",)))
    values = claim.list("values")
    expect(len(values) == len(a), "certificate: a value for each normal")
    for value, *both in zip(values, a, b):
        if touching:
            expect(all(low <= value <= high for low, high in both), "certificate: a slab does not hold the value")
        else:
            inside = all(low < value < high for low, high in both)
            expect(inside, "certificate: the value is not inside both slabs")
    if touching:
        i = place(claim.single("slab"), len(a), "slab")
        (first, last), (begin, end) = a[i], b[i]
        single = first == last or begin == end or last == begin or end == first
        expect(single, "certificate: these slabs have an interval in common")


def check_kdop_of_points(claim):
    claim.inputs("points", "normals")
    everything, listed = points_in_space(claim.input["points"], "points"), claim.input["normals"]
    expect(isinstance(listed, list) and listed, "normals: at least 1 normal")
    normals = [normal(one, f"normals[{i}]") for i, one in enumerate(listed)]
    claim.answers("slabs")
    slabs = claim.truth["slabs"]
    expect(isinstance(slabs, list) and len(slabs) == len(normals), "truth.slabs: as many slabs as normals")
    claim.expect_kind("extreme_points"), claim.facts("least", "greatest")
    least, greatest = claim.list("least"), claim.list("greatest")
    expect(len(least) == len(greatest) == len(normals), "certificate: two places for each normal")
    for i, n in enumerate(normals):
        low, high = exact_pair(slabs[i], f"truth.slabs[{i}]")
        values = [dot(n, p) for p in everything]
        first, last = (values[place(one, len(values), "point")] for one in (least[i], greatest[i]))
        expect((first, last) == (low, high), "certificate: the slab does not end at this point")
        expect(all(low <= value <= high for value in values), "truth: a point is not in the slab")
