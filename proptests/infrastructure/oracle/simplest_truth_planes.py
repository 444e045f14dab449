# SPDX-License-Identifier: Apache-2.0
"""The second truth of planes: heights over them, and a square root by its square."""
from fractions import Fraction

from simplest_truth_reading import Root, by_sign, cut, dot, number, point

# Operations of the chapter that have no second truth, and why.
WITHOUT = {
    "polygon_normal": "its unit vector is irrational; the checkers of certificates compare its squares",
}


def truth_point_ground_plane(q):
    height = number(q["point"][1])
    return {"side": by_sign(height, "below", "on", "above")}, abs(height)


def truth_point_plane(q):
    normal = point(q["plane"]["normal"])
    height = dot(normal, point(q["point"])) + number(q["plane"]["offset"])
    square = height * height / dot(normal, normal)
    return {"side": by_sign(height, "back", "on", "front"),
            "signed_distance": Root(square, by_sign(height, -1, 0, 1))}, square


def truth_point_plane_toi(q):
    """Cuts the interval [0, 1] to where the height over the plane, linear in t, is not positive."""
    normal, start, end = point(q["plane"]["normal"]), point(q["start"]), point(q["end"])
    first, last = (dot(normal, p) + number(q["plane"]["offset"]) for p in (start, end))
    behind = cut((Fraction(0), Fraction(1)), first - last, -first)
    truth = {"option_1": {"relation": "hit" if last <= 0 else "never"}, "option_2": {"relation": "never"}}
    if behind is not None:
        t = behind[0]
        p = [str(a + t * (b - a)) for a, b in zip(start, end)]
        truth["option_2"] = {"relation": "hit", "t": str(t), "point": p}
    return truth, None
