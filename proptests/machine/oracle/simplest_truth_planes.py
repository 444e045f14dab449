# SPDX-License-Identifier: Apache-2.0
"""The second truth of planes: heights over them, and a square root by its square."""
from fractions import Fraction

from simplest_truth_reading import Root, by_sign, cut, number, point

# Operations of the chapter that have no second truth, and why.
WITHOUT = {
    "polygon_normal": "its unit vector is irrational; the checkers of certificates compare its squares",
}


def truth_point_ground_plane(q):
    height = number(q["point"][1])
    return {"side": by_sign(height, "below", "on", "above")}, abs(height)


def truth_point_plane(q):
    normal, p = [number(n) for n in q["plane"]["normal"]], [number(n) for n in q["point"]]
    height = sum(n * x for n, x in zip(normal, p)) + number(q["plane"]["offset"])
    square = height * height / sum(n * n for n in normal)
    return {"side": by_sign(height, "back", "on", "front"),
            "signed_distance": Root(square, by_sign(height, -1, 0, 1))}, square


def truth_point_plane_toi(q):
    """Where the height over the plane, linear in t, is not positive: the interval [0, 1] cut."""
    normal = [number(n) for n in q["plane"]["normal"]]
    start, end = ([number(n) for n in q[name]] for name in ("start", "end"))
    first, last = (sum(n * x for n, x in zip(normal, p)) + number(q["plane"]["offset"]) for p in (start, end))
    behind = cut((Fraction(0), Fraction(1)), first - last, -first)
    truth = {"option_1": {"relation": "hit" if last <= 0 else "never"}, "option_2": {"relation": "never"}}
    if behind is not None:
        t = behind[0]
        p = [str(a + t * (b - a)) for a, b in zip(start, end)]
        truth["option_2"] = {"relation": "hit", "t": str(t), "point": p}
    return truth, None
