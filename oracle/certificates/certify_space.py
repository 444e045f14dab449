# SPDX-License-Identifier: Apache-2.0
"""How certify.py reads shapes of space, and boxes of the plane, as check_space.cpp does."""

from certify_reading import exact_value, expect, number, only, open_ring


def list_of_three(value, what):
    expect(isinstance(value, list) and len(value) == 3, what + ": a list of three")
    return value


def point_in_space(value, what):
    return tuple(number(n, f"{what}[{axis}]") for axis, n in enumerate(list_of_three(value, what)))


def points_in_space(value, what):
    expect(isinstance(value, list) and value, what + ": at least 1 point")
    return [point_in_space(point, f"{what}[{i}]") for i, point in enumerate(value)]


def plane(value, what):
    only(value, what, ["normal", "offset"])
    normal, offset = point_in_space(value["normal"], what + ".normal"), number(value["offset"], what + ".offset")
    expect(normal != (0, 0, 0), what + ".normal: nonzero normal")
    return normal, offset


def polygon_in_space(value, what):
    expect(isinstance(value, list), what + ": a list of vertices")
    return open_ring([point_in_space(vertex, f"{what}[{i}]") for i, vertex in enumerate(value)], what)


def ball(value, what):
    only(value, what, ["center", "radius"])
    center, radius = point_in_space(value["center"], what + ".center"), number(value["radius"], what + ".radius")
    expect(radius >= 0, what + ".radius: radius >= 0")
    return center, radius


def two_or_three(value, what):
    expect(isinstance(value, list) and len(value) in (2, 3), what + ": a list of two or three")
    return tuple(number(coordinate, f"{what}[{axis}]") for axis, coordinate in enumerate(value))


def ball_or_disc(value, what):
    """Two or three coordinates of the center."""
    only(value, what, ["center", "radius"])
    center, radius = two_or_three(value["center"], what + ".center"), number(value["radius"], what + ".radius")
    expect(radius >= 0, what + ".radius: radius >= 0")
    return center, radius


def box(value, what, corner=two_or_three):
    """(min, max), two or three coordinates of each."""
    only(value, what, ["min", "max"])
    low, high = corner(value["min"], what + ".min"), corner(value["max"], what + ".max")
    expect(len(high) == len(low), what + ".max: as many coordinates as min")
    for axis, (least, greatest) in enumerate(zip(low, high)):
        expect(least <= greatest, f"{what}.max[{axis}]: min <= max")
    return low, high


def box_in_space(value, what):
    return box(value, what, point_in_space)


def box_holds(low, high, p):
    return all(least <= x <= greatest for least, x, greatest in zip(low, p, high))


def exact_triple(value, what):
    return tuple(exact_value(n, f"{what}[{axis}]") for axis, n in enumerate(list_of_three(value, what)))


def triple(claim, name):
    return exact_triple(claim.certificate[name], "certificate." + name)


def minus(p, q):
    return tuple(x - y for x, y in zip(p, q))


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def cross(p, q):
    return p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]


def named(claim, fact, points):
    """The points of a list that a fact names by their places."""
    places = claim.list(fact)
    for place in places:
        expect(place.denominator == 1 and 0 <= place < len(points), f"certificate.{fact}: places of points")
    return [points[int(place)] for place in places]
