# SPDX-License-Identifier: Apache-2.0
"""The checks of certify.py for points, lines, segments and rays: one function an operation, as in check_lines.cpp."""

from certify_reading import circle, expect, line_of_two_points, number, point, ray, segment


def minus(p, q):
    return p[0] - q[0], p[1] - q[1]


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def along(start, t, step):
    return start[0] + t * step[0], start[1] + t * step[1]


def at(ends, t):
    return along(ends[0], t, minus(ends[1], ends[0]))


def within(t):
    return 0 <= t <= 1


def at_end(t):
    return t in (0, 1)


def expect_word(claim, field, value, below, zero, above):
    claim.answers(field)
    expect(claim.word(field) == (below if value < 0 else above if value > 0 else zero), f"truth: {field} is wrong")


def expect_separated(claim, below, above):
    normal, offset = claim.pair("normal"), claim.single("offset")
    held = all(dot(normal, p) < offset for p in below) and all(dot(normal, p) > offset for p in above)
    expect(held, "certificate: the line does not separate")


def expect_determinant(claim, u, v):
    determinant = claim.single("determinant")
    expect(determinant == cross(u, v), "certificate: the determinant is wrong")
    expect(determinant != 0, "certificate: the directions are parallel")


def check_explicit_line(claim):
    claim.inputs("slope", "intercept", "point")
    slope, intercept = number(claim.input["slope"], "slope"), number(claim.input["intercept"], "intercept")
    p = point(claim.input["point"], "point")
    claim.expect_kind("height"), claim.facts("height")
    height = claim.single("height")
    expect(height == p[1] - (slope * p[0] + intercept), "certificate: the height is wrong")
    expect_word(claim, "side", height, "below", "on", "above")


def check_implicit_circle(claim):
    claim.inputs("circle", "point")
    center, r = circle(claim.input["circle"], "circle")
    from_center = minus(point(claim.input["point"], "point"), center)
    claim.expect_kind("squares"), claim.facts("squared_distance", "squared_radius")
    distance, radius = claim.single("squared_distance"), claim.single("squared_radius")
    expect(distance == dot(from_center, from_center), "certificate: the squared distance is wrong")
    expect(radius == r * r, "certificate: the squared radius is wrong")
    expect_word(claim, "location", distance - radius, "inside", "boundary", "outside")


def check_line_point_at(claim):
    claim.inputs("line", "t")
    origin, direction = ray(claim.input["line"], "line")
    t = number(claim.input["t"], "t")
    claim.answers("point")
    claim.expect_kind("displacement"), claim.facts("displacement")
    step = claim.pair("displacement")
    expect(step == (t * direction[0], t * direction[1]), "certificate: the displacement is wrong")
    expect(claim.exact_point() == along(origin, 1, step), "truth: point is wrong")


def check_orientation(claim):
    claim.inputs("p0", "p1", "p")
    p0, p1, p = (point(claim.input[name], name) for name in ("p0", "p1", "p"))
    claim.expect_kind("determinant"), claim.facts("determinant")
    determinant = claim.single("determinant")
    expect(determinant == cross(minus(p1, p0), minus(p, p0)), "certificate: the determinant is wrong")
    expect_word(claim, "side", determinant, "right", "on", "left")


def check_point_on_segment(claim):
    claim.inputs("point", "segment")
    p, s = point(claim.input["point"], "point"), segment(claim.input["segment"], "segment")
    if claim.word("relation") == "on":
        claim.answers("relation", "t"), claim.expect_kind("weights"), claim.facts("weights")
        wa, wb = claim.pair("weights")
        expect(wa >= 0 and wb >= 0 and wa + wb == 1, "certificate: not weights of a segment")
        combination = wa * s[0][0] + wb * s[1][0], wa * s[0][1] + wb * s[1][1]
        expect(p == combination, "certificate: the weights give another point")
        t = claim.exact("t")
        expect(t == wb and (s[0] != s[1] or t == 0), "truth: t is wrong")
    else:
        expect(claim.word("relation") == "off", "truth: relation is wrong")
        claim.answers("relation"), claim.expect_kind("separating_line"), claim.facts("normal", "offset")
        expect_separated(claim, [p], s)


def check_line_line(claim):
    claim.inputs("a", "b")
    a, b = line_of_two_points(claim.input["a"], "a"), line_of_two_points(claim.input["b"], "b")
    u, v = minus(a[1], a[0]), minus(b[1], b[0])
    relation = claim.word("relation")
    if relation == "crossing":
        claim.answers("relation", "ta", "tb", "point"), claim.expect_kind("transversal"), claim.facts("determinant")
        expect_determinant(claim, u, v)
        p = claim.exact_point()
        expect(p == at(a, claim.exact("ta")), "truth: point is not at ta")
        expect(p == at(b, claim.exact("tb")), "truth: point is not at tb")
        return
    claim.answers("relation")
    if relation == "parallel":  # the lines are two different level lines of one linear form
        claim.expect_kind("level_lines"), claim.facts("normal")
        normal = claim.pair("normal")
        expect(dot(normal, u) == 0 and dot(normal, v) == 0, "certificate: not a normal of both lines")
        expect(dot(normal, a[0]) != dot(normal, b[0]), "certificate: the lines are on one level")
    else:
        expect(relation == "same", "truth: relation is wrong")
        claim.expect_kind("same_line"), claim.facts("on_a")
        first, second = claim.pair("on_a")
        expect(at(a, first) == b[0] and at(a, second) == b[1], "certificate: the points of b are not on a")


def check_segment_segment(claim):
    claim.inputs("a", "b")
    a, b = segment(claim.input["a"], "a"), segment(claim.input["b"], "b")
    relation, kind = claim.word("relation"), claim.kind()
    if relation == "disjoint":
        claim.answers("relation"), claim.expect_kind("separating_line"), claim.facts("normal", "offset")
        expect_separated(claim, a, b)
    elif relation == "overlap":
        claim.answers("relation", "overlap"), claim.expect_kind("overlap"), claim.facts("on_a", "on_b")
        p, q = claim.exact_overlap()
        expect(p < q, "truth: overlap is not in lexicographic order")
        on_a, on_b = claim.pair("on_a"), claim.pair("on_b")
        expect(all(map(within, on_a + on_b)), "certificate: a parameter outside [0, 1]")
        expect(at(a, on_a[0]) == p and at(a, on_a[1]) == q, "truth: overlap is not on a")
        expect(at(b, on_b[0]) == p and at(b, on_b[1]) == q, "truth: overlap is not on b")
        # Two different points of each: all is on one line, and nothing of a segment lies beyond its own end.
        ended = [at_end(on_a[i]) or at_end(on_b[i]) for i in (0, 1)]
        expect(all(ended), "truth: overlap goes further")
    else:
        expect(relation == "point", "truth: relation is wrong")
        claim.answers("relation", "ta", "tb", "point")
        ta, tb, p = claim.exact("ta"), claim.exact("tb"), claim.exact_point()
        expect(within(ta) and within(tb), "truth: a parameter outside [0, 1]")
        expect(p == at(a, ta), "truth: point is not at ta")
        expect(p == at(b, tb), "truth: point is not at tb")
        zero_length = a[0] == a[1], b[0] == b[1]
        settled = not (zero_length[0] and ta != 0) and not (zero_length[1] and tb != 0)
        expect(settled, "truth: a zero-length segment has parameter 0")
        if kind == "transversal":
            claim.facts("determinant"), expect_determinant(claim, minus(a[1], a[0]), minus(b[1], b[0]))
        elif kind == "single_point":
            claim.facts(), expect(any(zero_length), "certificate: neither segment is a single point")
        else:
            claim.expect_kind("supporting_line"), claim.facts("normal", "offset")
            normal, c = claim.pair("normal"), claim.single("offset")
            on_a, on_b = [dot(normal, end) for end in a], [dot(normal, end) for end in b]
            expect(max(on_a) <= c <= min(on_b), "certificate: the line does not support")
            expect(on_a != [c, c] or on_b != [c, c], "certificate: the line is touched more than once")


def check_ray_segment(claim):
    claim.inputs("ray", "segment")
    origin, direction = ray(claim.input["ray"], "ray")
    s = segment(claim.input["segment"], "segment")
    relation, kind = claim.word("relation"), claim.kind()
    if relation == "none":
        claim.answers("relation"), claim.expect_kind("separating_line"), claim.facts("normal", "offset")
        expect_separated(claim, [origin], s)
        expect(dot(claim.pair("normal"), direction) <= 0, "certificate: the ray crosses the line")
    elif relation == "overlap":
        claim.answers("relation", "t", "overlap"), claim.expect_kind("overlap"), claim.facts("on_ray", "on_segment")
        p, q = claim.exact_overlap()
        t, on_s = claim.pair("on_ray"), claim.pair("on_segment")
        expect(claim.exact("t") == t[0], "truth: t is wrong")
        expect(0 <= t[0] < t[1], "certificate: the parameters do not rise from 0")
        expect(all(map(within, on_s)), "certificate: a parameter outside [0, 1]")
        on_ray = along(origin, t[0], direction) == p and along(origin, t[1], direction) == q
        expect(on_ray, "truth: overlap is not on the ray")
        expect(at(s, on_s[0]) == p and at(s, on_s[1]) == q, "truth: overlap is not on the segment")
        expect((t[0] == 0 or at_end(on_s[0])) and at_end(on_s[1]), "truth: overlap goes further")
    else:
        expect(relation == "point", "truth: relation is wrong")
        claim.answers("relation", "t", "point")
        t, p = claim.exact("t"), claim.exact_point()
        expect(t >= 0, "truth: t is negative")
        expect(p == along(origin, t, direction), "truth: point is not at t")
        if kind == "single_point":
            claim.facts(), expect(s[0] == s[1], "certificate: the segment is not a single point")
            expect(p == s[0], "truth: point is not on the segment")
            return
        claim.facts("on_segment", *(["determinant"] if kind == "transversal" else ["normal", "offset"]))
        on_s = claim.single("on_segment")
        expect(within(on_s) and p == at(s, on_s), "truth: point is not on the segment")
        if kind == "transversal":
            expect_determinant(claim, direction, minus(s[1], s[0]))
            return
        claim.expect_kind("supporting_line")
        normal, c = claim.pair("normal"), claim.single("offset")
        start, slope, levels = dot(normal, origin), dot(normal, direction), [dot(normal, end) for end in s]
        expect(start <= c and slope <= 0 and min(levels) >= c, "certificate: the line does not support")
        expect(slope < 0 or levels != [c, c], "certificate: the line is touched more than once")
