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
