#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks certificates of geometric answers with fractions alone.

usage: certify.py [FILE...]    (standard input without a FILE, or where FILE is -)

Each line is one claim, {"op":..,"input":{..},"truth":{..},"certificate":{"kind":..,facts}}; other keys are ignored. Prints
every refused line with its reason and then "N certificates, M refused". Exit code: 0 all hold, 1 some refused, 2 a file
cannot be read. The same checks as oracle/certificates/check_lines.cpp and check_circle.cpp, and the same reasons.
"""

import json
import re
import sys
from fractions import Fraction

if hasattr(sys, "set_int_max_str_digits"):
    sys.set_int_max_str_digits(0)

WRONG_KIND = "certificate: no such kind for this truth"


class Refusal(Exception):
    pass


def expect(holds, reason):
    if not holds:
        raise Refusal(reason)


# Reading


def only(thing, what, names):
    expect(isinstance(thing, dict), what + ": an object")
    for name in names:
        expect(name in thing, f"{what}: field {name} is missing")
    expect(set(thing) == set(names), what + ": an unexpected field")


def binary64(value):
    if value == 0:
        return True
    top, bottom = abs(value.numerator), value.denominator
    low, high, scale = (top & -top).bit_length() - 1, top.bit_length(), bottom.bit_length() - 1
    return bottom & (bottom - 1) == 0 and high - low <= 53 and low - scale >= -1074 and high - scale <= 1024


HEXADECIMAL = re.compile(r"([+-]?)0[xX]([0-9a-fA-F]*)(?:\.([0-9a-fA-F]*))?(?:[pP]([+-]?[0-9]{1,5}))?")


def number(value, what):
    malformed = what + ": a number or a hexadecimal float string"
    if isinstance(value, str):
        found = HEXADECIMAL.fullmatch(value)
        expect(found is not None, malformed)
        sign, whole, part, power = found.group(1), found.group(2), found.group(3) or "", int(found.group(4) or 0)
        expect(0 < len(whole + part) <= 1000, malformed)
        exact = Fraction(int(whole + part, 16)) * Fraction(2) ** (power - 4 * len(part))
        expect(binary64(exact), what + ": a binary64 number")
        return -exact if sign == "-" else exact
    expect(isinstance(value, (int, float)) and not isinstance(value, bool), malformed)
    try:
        return Fraction(float(value))
    except (OverflowError, ValueError):
        raise Refusal(what + ": finite number") from None


def list_of_two(value, what):
    expect(isinstance(value, list) and len(value) == 2, what + ": a list of two")
    return value


def point(value, what):
    x, y = list_of_two(value, what)
    return number(x, what + "[0]"), number(y, what + "[1]")


def segment(value, what):
    a, b = list_of_two(value, what)
    return point(a, what + "[0]"), point(b, what + "[1]")


def line_of_two_points(value, what):
    a, b = segment(value, what)
    expect(a != b, what + ": two distinct points")
    return a, b


def ray(value, what):
    only(value, what, ["origin", "direction"])
    origin, direction = point(value["origin"], what + ".origin"), point(value["direction"], what + ".direction")
    expect(direction != (0, 0), what + ".direction: nonzero direction")
    return origin, direction


def circle(value, what):
    only(value, what, ["center", "radius"])
    center, radius = point(value["center"], what + ".center"), number(value["radius"], what + ".radius")
    expect(radius >= 0, what + ".radius: radius >= 0")
    return center, radius


EXACT = re.compile(r"(-?[0-9]+)(?:/([0-9]+))?")


def exact_value(value, what):
    malformed = what + ': an exact value "p/q"'
    expect(isinstance(value, str), malformed)
    found = EXACT.fullmatch(value)
    expect(found is not None, malformed)
    below = int(found.group(2) or 1)
    expect(below != 0, malformed)
    return Fraction(int(found.group(1)), below)


def exact_pair(value, what):
    x, y = list_of_two(value, what)
    return exact_value(x, what + "[0]"), exact_value(y, what + "[1]")


class Claim:
    def __init__(self, line):
        self.input, self.truth, self.certificate = line["input"], line["truth"], line["certificate"]

    def inputs(self, *names):
        only(self.input, "input", names)

    def answers(self, *names):
        only(self.truth, "truth", names)

    def word(self, name):
        expect(isinstance(self.truth, dict) and isinstance(self.truth.get(name), str), f"truth: field {name} is missing")
        return self.truth[name]

    def exact(self, name):
        return exact_value(self.truth[name], "truth." + name)

    def exact_point(self):
        return exact_pair(self.truth["point"], "truth.point")

    def exact_overlap(self):
        overlap = list_of_two(self.truth["overlap"], "truth.overlap")
        return exact_pair(overlap[0], "truth.overlap[0]"), exact_pair(overlap[1], "truth.overlap[1]")

    def kind(self):
        held = isinstance(self.certificate, dict) and isinstance(self.certificate.get("kind"), str)
        expect(held, "certificate: field kind is missing")
        return self.certificate["kind"]

    def expect_kind(self, kind):
        expect(self.kind() == kind, WRONG_KIND)

    def facts(self, *names):
        for name in names:
            expect(name in self.certificate, f"certificate: field {name} is missing")
        expect(len(self.certificate) == len(names) + 1, "certificate: an unexpected field")

    def single(self, name):
        value, what = self.certificate[name], "certificate." + name
        expect(isinstance(value, list) and len(value) == 1, what + ": a list of one")
        return exact_value(value[0], what + "[0]")

    def pair(self, name):
        return exact_pair(self.certificate[name], "certificate." + name)


# Lines


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
    claim.inputs("line", "t"), claim.answers("point")
    origin, direction = ray(claim.input["line"], "line")
    t = number(claim.input["t"], "t")
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


# Circle: whole numbers of some unit 2^-bits, low and high around the true value


def quotients(low, high, divisor):
    return low // divisor, -(-high // divisor)


def negated(x):
    return -x[1], -x[0]


def plus(total, term, sign):
    term = term if sign > 0 else negated(term)
    return total[0] + term[0], total[1] + term[1]


def arc_tangent_of_inverse(q, bits):
    """1/q - 1/(3 q^3) + ...: what is left out is smaller than the first term left out, at most one unit."""
    power, total, odd, sign = quotients(1 << bits, 1 << bits, q), (0, 0), 1, 1
    while (term := quotients(*power, odd))[1] > 1:
        total = plus(total, term, sign)
        power, odd, sign = quotients(*power, q * q), odd + 2, -sign
    return total[0] - 1, total[1] + 1


def machin(bits):
    fifth, small = arc_tangent_of_inverse(5, bits), arc_tangent_of_inverse(239, bits)
    return 16 * fifth[0] - 4 * small[1], 16 * fifth[1] - 4 * small[0]


def series(term, x, k, bits):
    """Sine (term = x, k = 2) or cosine (term = 1, k = 1) of x in [0, 1]: the terms fall and change sign."""
    total, sign = (0, 0), 1
    while term[1] > 1:
        total = plus(total, term, sign)
        term = quotients(term[0] * x[0] * x[0], term[1] * x[1] * x[1], k * (k + 1) << 2 * bits)
        k, sign = k + 2, -sign
    return total[0] - 1, total[1] + 1


def rest_of_turn(u, turns, bits):
    fine = bits + max(1, abs(turns).bit_length())
    low, high = machin(fine)
    if turns < 0:
        low, high = high, low
    low, high = (u - Fraction(turns * bound, 2 << fine) for bound in (high, low))
    return (low.numerator << bits) // low.denominator, -((-high.numerator << bits) // high.denominator)


def expect_cosine_and_sine(u, cosine, sine, turns, bits):
    expect(bits.denominator == 1 and 1 <= bits <= 8192, "certificate: bits is not from 1 to 8192")
    in_range = turns.denominator == 1 and abs(turns.numerator).bit_length() <= 1030
    expect(in_range, "certificate: quarter_turns is out of range")
    bits, turns = int(bits), int(turns)
    rest, one = rest_of_turn(u, turns, bits), 1 << bits
    negative = rest[1] <= 0
    x = negated(rest) if negative else rest
    expect(0 <= x[0] and x[1] <= one, "certificate: quarter_turns or bits do not fit u")
    c, s = series((one, one), x, 1, bits), series(x, x, 2, bits)
    s = negated(s) if negative else s
    turned = [(c, s), (negated(s), c), (negated(c), negated(s)), (s, negated(c))][turns % 4]
    for claimed, computed, name in ((cosine, turned[0], "cosine"), (sine, turned[1], "sine")):
        encloses = claimed[0] * one <= computed[0] and computed[1] <= claimed[1] * one
        expect(encloses, f"certificate: {name} is wrong")


def ulp_exponent(value):
    size = abs(value)
    order = size.numerator.bit_length() - size.denominator.bit_length()
    if size < Fraction(2) ** order:
        order -= 1
    return min(max(order - 52, -1074), 971)


def expect_rounds_alike(claimed, low, high):
    same_sign = claimed * low > 0 and claimed * high > 0
    expect(same_sign, "truth: the sign of point is not proved")
    ulp = Fraction(2) ** ulp_exponent(claimed)
    close = ulp / 2**60
    expect(abs(claimed - low) < close and abs(claimed - high) < close, "truth: point is too far off")
    nearest = {min(round(abs(value / ulp)), 1 << 53) for value in (low, claimed, high)}  # round: ties to even
    expect(len(nearest) == 1, "truth: the rounding of point is not proved")


def check_parametric_circle(claim):
    claim.inputs("circle", "u"), claim.answers("point")
    center, radius = circle(claim.input["circle"], "circle")
    u, p = number(claim.input["u"], "u"), claim.exact_point()
    if claim.kind() == "exact":
        claim.facts(), expect(u == 0 or radius == 0, "certificate: neither u nor the radius is 0")
        expect(p == (center[0] + radius, center[1]), "truth: point is wrong")
        return
    claim.expect_kind("enclosure")
    expect(u != 0 and radius != 0, "certificate: the point is rational")
    claim.facts("cosine", "sine", "quarter_turns", "bits")
    cosine, sine = claim.pair("cosine"), claim.pair("sine")
    expect_cosine_and_sine(u, cosine, sine, claim.single("quarter_turns"), claim.single("bits"))
    for axis, unit in enumerate((cosine, sine)):
        expect_rounds_alike(p[axis], center[axis] + radius * unit[0], center[axis] + radius * unit[1])


CHECKS = {
    "explicit_line": check_explicit_line,
    "implicit_circle": check_implicit_circle,
    "parametric_circle": check_parametric_circle,
    "line_point_at": check_line_point_at,
    "point_on_segment": check_point_on_segment,
    "line_line": check_line_line,
    "segment_segment": check_segment_segment,
    "ray_segment": check_ray_segment,
    "orientation": check_orientation,
}


def no_constant(name):
    raise ValueError(name)


def refuse(text):
    """Why the claim in one line of text is not accepted, or None."""
    try:
        line = json.loads(text, parse_constant=no_constant)
    except (ValueError, RecursionError):
        return "not JSON"
    try:
        expect(isinstance(line, dict), "claim: an object")
        for name in ("op", "input", "truth", "certificate"):
            expect(name in line, f"claim: field {name} is missing")
        expect(isinstance(line["op"], str), "op: a string")
        expect(line["op"] in CHECKS, "op: not an operation with certificates")
        CHECKS[line["op"]](Claim(line))
    except Refusal as refusal:
        return str(refusal)
    return None


def main(paths):
    total = refused = 0
    for path in paths or ["-"]:
        try:
            stream = sys.stdin.buffer if path == "-" else open(path, "rb")
        except OSError as error:
            print(f"{path}: {error.strerror}", file=sys.stderr)
            return 2
        with stream:
            for position, raw in enumerate(stream, 1):
                if not raw.strip():
                    continue
                total += 1
                try:
                    reason = refuse(raw.decode("utf-8"))
                except UnicodeDecodeError:
                    reason = "not JSON"
                if reason is not None:
                    refused += 1
                    print(f"{path}:{position}: {reason}")
    print(f"{total} certificates, {refused} refused")
    return 1 if refused else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
