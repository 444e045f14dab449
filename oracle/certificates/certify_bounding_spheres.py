# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for balls around points, as in check_bounding_spheres.cpp."""

from fractions import Fraction

from certify_reading import WRONG_KIND, expect, only
from certify_space import dot, exact_triple, named, points_in_space
from certify_sums import over_one, times, total
from certify_surd import exact_surd

METHODS = ("box", "centroid", "ritter", "smallest")
NOT_REACHED = "certificate: a point is not on the boundary of the ball"


def combined(weights, support):
    """(the weighted mean of the points, the weighted mean of their squares)"""
    expect(len(weights) == len(support), "certificate.weights: as many as points")
    expect(all(weight >= 0 for weight in weights), "certificate: a weight is negative")
    terms = [times(weight, (1, *p, dot(p, p))) for weight, p in zip(weights, support)]
    (weight, *mean, square), whole = total(terms or [((0,) * 5, 1)])
    expect(weight == whole, "certificate: the weights do not add up to 1")
    return tuple(Fraction(x, whole) for x in mean), Fraction(square, whole)


def middle(points, method):
    axes = list(zip(*points))
    if method == "box":
        return tuple((min(axis) + max(axis)) / 2 for axis in axes)
    return tuple(sum(axis) / len(points) for axis in axes)


def check_bounding_sphere(claim):
    """Why that proves it stands in check_bounding_spheres.cpp."""
    with_method = isinstance(claim.input, dict) and "method" in claim.input
    claim.inputs(*(("points", "method") if with_method else ("points",)))
    points = points_in_space(claim.input["points"], "points")
    method = claim.input.get("method", "smallest")
    expect(isinstance(method, str) and method in METHODS, "method: one of box, centroid, ritter, smallest")
    claim.answers("sphere")
    sphere = claim.truth["sphere"]
    only(sphere, "truth.sphere", ["center", "radius"])
    center = exact_triple(sphere["center"], "truth.sphere.center")
    radius = exact_surd(sphere["radius"], "truth.sphere.radius")
    expect(radius.sign() >= 0, "truth: the radius is negative")
    square, (scaled, scale) = radius.square(), over_one(center)
    scaled_square = square * scale**2

    def beyond(p):
        way = tuple(x * scale - y for x, y in zip(p, scaled))
        return -(scaled_square + -dot(way, way)).sign()

    expect(all(beyond(p) <= 0 for p in points), "truth: a point is outside of the ball")
    kind = claim.kind()
    if method in ("box", "centroid"):
        expect(kind == "farthest_point", WRONG_KIND), claim.facts("point")
        farthest = named(claim, "point", points)
        expect(len(farthest) == 1, "certificate.point: a list of one")
        expect(center == middle(points, method), "truth: the center is wrong")
        expect(beyond(farthest[0]) == 0, NOT_REACHED)
        return
    expect(kind == ("support" if method == "smallest" else "lower_bound"), WRONG_KIND), claim.facts("points", "weights")
    support = named(claim, "points", points)
    weights = claim.list("weights")
    balanced, mean_square = combined(weights, support)
    if method == "smallest":
        expect(balanced == center, "certificate: the weights do not give the center")
        expect(all(beyond(p) == 0 for p in support), NOT_REACHED)
        return
    bound = mean_square - dot(balanced, balanced)  # the weighted mean of the squared distances from there
    expect((square + Fraction(-9, 4) * bound).sign() <= 0, "truth: the radius is more than 3/2 of the least")
