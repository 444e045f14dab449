// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "oracle/certificates/check_reading.h"

namespace touchstone::certify {
namespace {

/// The enumerator for the sign of an exact number.
void expect_word(const Claim& claim, const char* field, int sign, const char* below, const char* zero,
                 const char* above) {
  claim.answers({field});
  expect(claim.word(field) == (sign < 0   ? below
                               : sign > 0 ? above
                                          : zero),
         std::string("truth: ") + field + " is wrong");
}

bool within(const Rational& t) { return sgn(t) >= 0 && t <= 1; }
bool at_end(const Rational& t) { return sgn(t) == 0 || t == 1; }
bool zero_length(const Ends& s) { return s.a == s.b; }
Pair at(const Ends& s, const Rational& t) { return along(s.a, t, s.b - s.a); }

/// Requires normal . p < offset for all of `below`, > offset for all of `above`. A zero normal cannot satisfy that.
void expect_separated(const Claim& claim, std::initializer_list<Pair> below, std::initializer_list<Pair> above) {
  const Pair normal = claim.pair("normal");
  const Rational offset = claim.single("offset");
  const char* const reason = "certificate: the line does not separate";
  for (const Pair& p : below) expect(dot(normal, p) < offset, reason);
  for (const Pair& p : above) expect(dot(normal, p) > offset, reason);
}

/// True if only one point of the shape with these ends is on the line: they are on one side, and not both on it.
bool touched_once(const Rational& a, const Rational& b, const Rational& offset) { return a != offset || b != offset; }

void expect_determinant(const Claim& claim, const Pair& u, const Pair& v) {
  const Rational determinant = claim.single("determinant");
  expect(determinant == cross(u, v), "certificate: the determinant is wrong");
  expect(sgn(determinant) != 0, "certificate: the directions are parallel");
}

void check_explicit_line(const Claim& claim) {
  claim.inputs({"slope", "intercept", "point"});
  const Rational slope = number(claim.input["slope"], "slope"),
                 intercept = number(claim.input["intercept"], "intercept");
  const Pair p = point(claim.input["point"], "point");
  claim.expect_kind("height"), claim.facts({"height"});
  const Rational height = claim.single("height");
  expect(height == p.y - (slope * p.x + intercept), "certificate: the height is wrong");
  expect_word(claim, "side", sgn(height), "below", "on", "above");
}

void check_implicit_circle(const Claim& claim) {
  claim.inputs({"circle", "point"});
  const Circle c = circle(claim.input["circle"], "circle");
  const Pair from_center = point(claim.input["point"], "point") - c.center;
  claim.expect_kind("squares"), claim.facts({"squared_distance", "squared_radius"});
  const Rational distance = claim.single("squared_distance"), radius = claim.single("squared_radius");
  expect(distance == dot(from_center, from_center), "certificate: the squared distance is wrong");
  expect(radius == c.radius * c.radius, "certificate: the squared radius is wrong");
  expect_word(claim, "location", cmp(distance, radius), "inside", "boundary", "outside");
}

void check_line_point_at(const Claim& claim) {
  claim.inputs({"line", "t"});
  const Ray line = ray(claim.input["line"], "line");
  const Rational t = number(claim.input["t"], "t");
  claim.answers({"point"});
  claim.expect_kind("displacement"), claim.facts({"displacement"});
  const Pair step = claim.pair("displacement");
  expect(step == Pair{Rational(t * line.direction.x), Rational(t * line.direction.y)},
         "certificate: the displacement is wrong");
  expect(exact_pair(claim.truth["point"], "truth.point") == along(line.origin, 1, step), "truth: point is wrong");
}

void check_orientation(const Claim& claim) {
  claim.inputs({"p0", "p1", "p"});
  const Pair p0 = point(claim.input["p0"], "p0"), p1 = point(claim.input["p1"], "p1"), p = point(claim.input["p"], "p");
  claim.expect_kind("determinant"), claim.facts({"determinant"});
  const Rational determinant = claim.single("determinant");
  expect(determinant == cross(p1 - p0, p - p0), "certificate: the determinant is wrong");
  expect_word(claim, "side", sgn(determinant), "right", "on", "left");
}

void check_point_on_segment(const Claim& claim) {
  claim.inputs({"point", "segment"});
  const Pair p = point(claim.input["point"], "point");
  const Ends s = segment(claim.input["segment"], "segment");
  if (claim.word("relation") == "on") {
    claim.answers({"relation", "t"}), claim.expect_kind("weights"), claim.facts({"weights"});
    const Pair weights = claim.pair("weights");
    expect(sgn(weights.x) >= 0 && sgn(weights.y) >= 0 && weights.x + weights.y == 1,
           "certificate: not weights of a segment");
    expect(p == Pair{Rational(weights.x * s.a.x + weights.y * s.b.x), Rational(weights.x * s.a.y + weights.y * s.b.y)},
           "certificate: the weights give another point");
    const Rational t = exact_value(claim.truth["t"], "truth.t");
    expect(t == weights.y && (!zero_length(s) || sgn(t) == 0), "truth: t is wrong");
  } else {
    expect(claim.word("relation") == "off", "truth: relation is wrong");
    claim.answers({"relation"}), claim.expect_kind("separating_line"), claim.facts({"normal", "offset"});
    expect_separated(claim, {p}, {s.a, s.b});
  }
}

void check_line_line(const Claim& claim) {
  claim.inputs({"a", "b"});
  const Ends a = line_of_two_points(claim.input["a"], "a"), b = line_of_two_points(claim.input["b"], "b");
  const Pair u = a.b - a.a, v = b.b - b.a;
  const std::string relation = claim.word("relation");
  if (relation == "crossing") {
    claim.answers({"relation", "ta", "tb", "point"}), claim.expect_kind("transversal"), claim.facts({"determinant"});
    expect_determinant(claim, u, v);
    const Pair p = exact_pair(claim.truth["point"], "truth.point");
    expect(p == at(a, exact_value(claim.truth["ta"], "truth.ta")), "truth: point is not at ta");
    expect(p == at(b, exact_value(claim.truth["tb"], "truth.tb")), "truth: point is not at tb");
    return;
  }
  claim.answers({"relation"});
  if (relation == "parallel") {  // the lines are two different level lines of one linear form
    claim.expect_kind("level_lines"), claim.facts({"normal"});
    const Pair normal = claim.pair("normal");
    expect(sgn(dot(normal, u)) == 0 && sgn(dot(normal, v)) == 0, "certificate: not a normal of both lines");
    expect(dot(normal, a.a) != dot(normal, b.a), "certificate: the lines are on one level");
  } else {
    expect(relation == "same", "truth: relation is wrong");
    claim.expect_kind("same_line"), claim.facts({"on_a"});
    const Pair on_a = claim.pair("on_a");
    expect(at(a, on_a.x) == b.a && at(a, on_a.y) == b.b, "certificate: the points of b are not on a");
  }
}

void check_segment_segment(const Claim& claim) {
  claim.inputs({"a", "b"});
  const Ends a = segment(claim.input["a"], "a"), b = segment(claim.input["b"], "b");
  const std::string relation = claim.word("relation"), kind = claim.kind();
  if (relation == "disjoint") {
    claim.answers({"relation"}), claim.expect_kind("separating_line"), claim.facts({"normal", "offset"});
    expect_separated(claim, {a.a, a.b}, {b.a, b.b});
  } else if (relation == "overlap") {
    claim.answers({"relation", "overlap"}), claim.expect_kind("overlap"), claim.facts({"on_a", "on_b"});
    const json& overlap = claim.truth["overlap"];
    expect(overlap.is_array() && overlap.size() == 2, "truth.overlap: a list of two");
    const Pair p = exact_pair(overlap[0], "truth.overlap[0]"), q = exact_pair(overlap[1], "truth.overlap[1]");
    expect(p.x < q.x || (p.x == q.x && p.y < q.y), "truth: overlap is not in lexicographic order");
    const Pair on_a = claim.pair("on_a"), on_b = claim.pair("on_b");
    expect(within(on_a.x) && within(on_a.y) && within(on_b.x) && within(on_b.y),
           "certificate: a parameter outside [0, 1]");
    expect(at(a, on_a.x) == p && at(a, on_a.y) == q, "truth: overlap is not on a");
    expect(at(b, on_b.x) == p && at(b, on_b.y) == q, "truth: overlap is not on b");
    // Two different points of each: everything is collinear, and no part of a segment lies beyond its own end.
    expect((at_end(on_a.x) || at_end(on_b.x)) && (at_end(on_a.y) || at_end(on_b.y)), "truth: overlap goes further");
  } else {
    expect(relation == "point", "truth: relation is wrong");
    claim.answers({"relation", "ta", "tb", "point"});
    const Rational ta = exact_value(claim.truth["ta"], "truth.ta"), tb = exact_value(claim.truth["tb"], "truth.tb");
    const Pair p = exact_pair(claim.truth["point"], "truth.point");
    expect(within(ta) && within(tb), "truth: a parameter outside [0, 1]");
    expect(p == at(a, ta), "truth: point is not at ta");
    expect(p == at(b, tb), "truth: point is not at tb");
    expect(!(zero_length(a) && sgn(ta) != 0) && !(zero_length(b) && sgn(tb) != 0),
           "truth: a zero-length segment has parameter 0");
    if (kind == "transversal") {
      claim.facts({"determinant"}), expect_determinant(claim, a.b - a.a, b.b - b.a);
    } else if (kind == "single_point") {
      claim.facts({}), expect(zero_length(a) || zero_length(b), "certificate: neither segment is a single point");
    } else {
      claim.expect_kind("supporting_line"), claim.facts({"normal", "offset"});
      const Pair n = claim.pair("normal");
      const Rational c = claim.single("offset");
      const Rational aa = dot(n, a.a), ab = dot(n, a.b), ba = dot(n, b.a), bb = dot(n, b.b);
      expect(aa <= c && ab <= c && ba >= c && bb >= c, "certificate: the line does not support");
      expect(touched_once(aa, ab, c) || touched_once(ba, bb, c), "certificate: the line is touched more than once");
    }
  }
}

void check_ray_segment(const Claim& claim) {
  claim.inputs({"ray", "segment"});
  const Ray r = ray(claim.input["ray"], "ray");
  const Ends s = segment(claim.input["segment"], "segment");
  const std::string relation = claim.word("relation"), kind = claim.kind();
  if (relation == "none") {
    claim.answers({"relation"}), claim.expect_kind("separating_line"), claim.facts({"normal", "offset"});
    expect_separated(claim, {r.origin}, {s.a, s.b});
    expect(sgn(dot(claim.pair("normal"), r.direction)) <= 0, "certificate: the ray crosses the line");
  } else if (relation == "overlap") {
    claim.answers({"relation", "t", "overlap"}), claim.expect_kind("overlap"), claim.facts({"on_ray", "on_segment"});
    const json& overlap = claim.truth["overlap"];
    expect(overlap.is_array() && overlap.size() == 2, "truth.overlap: a list of two");
    const Pair p = exact_pair(overlap[0], "truth.overlap[0]"), q = exact_pair(overlap[1], "truth.overlap[1]");
    const Pair t = claim.pair("on_ray"), on_s = claim.pair("on_segment");
    expect(exact_value(claim.truth["t"], "truth.t") == t.x, "truth: t is wrong");
    expect(sgn(t.x) >= 0 && t.x < t.y, "certificate: the parameters do not rise from 0");
    expect(within(on_s.x) && within(on_s.y), "certificate: a parameter outside [0, 1]");
    expect(along(r.origin, t.x, r.direction) == p && along(r.origin, t.y, r.direction) == q,
           "truth: overlap is not on the ray");
    expect(at(s, on_s.x) == p && at(s, on_s.y) == q, "truth: overlap is not on the segment");
    expect((sgn(t.x) == 0 || at_end(on_s.x)) && at_end(on_s.y), "truth: overlap goes further");
  } else {
    expect(relation == "point", "truth: relation is wrong");
    claim.answers({"relation", "t", "point"});
    const Rational t = exact_value(claim.truth["t"], "truth.t");
    const Pair p = exact_pair(claim.truth["point"], "truth.point");
    expect(sgn(t) >= 0, "truth: t is negative");
    expect(p == along(r.origin, t, r.direction), "truth: point is not at t");
    if (kind == "single_point") {
      claim.facts({}), expect(zero_length(s), "certificate: the segment is not a single point");
      expect(p == s.a, "truth: point is not on the segment");
      return;
    }
    const bool transversal = kind == "transversal";
    transversal ? claim.facts({"on_segment", "determinant"}) : claim.facts({"on_segment", "normal", "offset"});
    const Rational on_s = claim.single("on_segment");
    expect(within(on_s) && p == at(s, on_s), "truth: point is not on the segment");
    if (transversal) return expect_determinant(claim, r.direction, s.b - s.a);
    claim.expect_kind("supporting_line");
    const Pair n = claim.pair("normal");
    const Rational c = claim.single("offset");
    const Rational start = dot(n, r.origin), slope = dot(n, r.direction), sa = dot(n, s.a), sb = dot(n, s.b);
    expect(start <= c && sgn(slope) <= 0 && sa >= c && sb >= c, "certificate: the line does not support");
    expect(sgn(slope) < 0 || touched_once(sa, sb, c), "certificate: the line is touched more than once");
  }
}

}  // namespace

Checks checks_of_lines() {
  return {{"explicit_line", check_explicit_line},       {"implicit_circle", check_implicit_circle},
          {"line_point_at", check_line_point_at},       {"orientation", check_orientation},
          {"point_on_segment", check_point_on_segment}, {"line_line", check_line_line},
          {"segment_segment", check_segment_segment},   {"ray_segment", check_ray_segment}};
}

}  // namespace touchstone::certify
