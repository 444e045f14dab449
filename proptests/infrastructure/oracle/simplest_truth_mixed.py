# SPDX-License-Identifier: Apache-2.0
"""The second truths of shapes of two chapters, for simplest_truth.py."""
from simplest_truth_reading import dot, number, point


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
