// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>

#include "oracle/certificates/check_space.h"

namespace touchstone::certify {
namespace {

/// The fact `axis`: a number from 0.
std::size_t axis_of(const Claim& claim, const Box& box) {
  const Rational axis = claim.single("axis");
  for (std::size_t k = 0; k < box.axes(); ++k)
    if (axis == static_cast<std::uint64_t>(k)) return k;
  throw Refusal("certificate.axis: no axis of the boxes");
}

std::vector<Rational> point_of(const Claim& claim, const Box& box) {
  std::vector<Rational> point = claim.list("point");
  expect(point.size() == box.axes(), "certificate.point: as many coordinates as the boxes");
  return point;
}

bool holds_inside(const Box& box, const std::vector<Rational>& point) {
  for (std::size_t k = 0; k < box.axes(); ++k)
    if (point[k] <= box.min[k] || point[k] >= box.max[k]) return false;
  return true;
}

/// Requires that every point of one box is below the value on that axis, every point of the other above.
void check_separated(const Claim& claim, const Box& a, const Box& b) {
  claim.expect_kind("separating_axis"), claim.facts({"axis", "value"});
  const std::size_t k = axis_of(claim, a);
  const Rational value = claim.single("value");
  expect((a.max[k] < value && value < b.min[k]) || (b.max[k] < value && value < a.min[k]),
         "certificate: the axis does not separate");
}

/// Requires a common point, and an axis on which no number is strictly between min and max of both boxes.
void check_touching(const Claim& claim, const Box& a, const Box& b) {
  const bool flat = claim.kind() == "flat_axis";
  expect(flat || claim.kind() == "supporting_axis", wrong_kind), claim.facts({"point", "axis"});
  const std::vector<Rational> point = point_of(claim, a);
  expect(a.holds(point) && b.holds(point), "certificate: the point is not in both boxes");
  const std::size_t k = axis_of(claim, a);
  if (flat) {
    expect(a.min[k] == a.max[k] || b.min[k] == b.max[k], "certificate: no box is flat on the axis");
  } else {
    expect((a.max[k] <= point[k] && point[k] <= b.min[k]) || (b.max[k] <= point[k] && point[k] <= a.min[k]),
           "certificate: the axis does not support");
  }
}

void check_aabb_aabb(const Claim& claim) {
  claim.inputs({"a", "b"});
  const Box a = box(claim.input["a"], "a"), b = box(claim.input["b"], "b");
  expect(b.axes() == a.axes(), "b: as many coordinates as a");
  claim.answers({"contact"});
  const std::string contact = claim.word("contact");
  if (contact == "disjoint") {
    check_separated(claim, a, b);
  } else if (contact == "touching") {
    check_touching(claim, a, b);
  } else {
    expect(contact == "overlapping", "truth: contact is wrong");
    claim.expect_kind("common_interior_point"), claim.facts({"point"});
    const std::vector<Rational> point = point_of(claim, a);
    expect(holds_inside(a, point) && holds_inside(b, point), "certificate: the point is not inside both boxes");
  }
}

/// nearest_in_interval.h explains why nothing in the box is nearer than x: the conditions of Karush, Kuhn and Tucker.
void check_closest_point_on_aabb(const Claim& claim) {
  claim.inputs({"point", "aabb"});
  const std::vector<Rational> p = two_or_three(claim.input["point"], "point");
  const Box b = box(claim.input["aabb"], "aabb");
  expect(b.axes() == p.size(), "aabb: as many coordinates as point");
  claim.answers({"point"});
  const json& answer = claim.truth["point"];
  expect(answer.is_array() && answer.size() == p.size(), "truth.point: as many coordinates as the box");
  std::vector<Rational> x;
  for (const json& value : answer) x.push_back(exact_value(value, "truth.point[" + std::to_string(x.size()) + "]"));
  claim.expect_kind("multipliers"), claim.facts({"lower", "upper"});
  const std::vector<Rational> lower = claim.list("lower"), upper = claim.list("upper");
  expect(lower.size() == p.size() && upper.size() == p.size(), "certificate: as many multipliers as coordinates");
  expect(b.holds(x), "truth: the point is not in the box");
  for (std::size_t k = 0; k < p.size(); ++k) {
    expect(sgn(lower[k]) >= 0 && sgn(upper[k]) >= 0, "certificate: a multiplier is negative");
    expect((sgn(lower[k]) == 0 || x[k] == b.min[k]) && (sgn(upper[k]) == 0 || x[k] == b.max[k]),
           "certificate: a multiplier of a bound that is not attained");
    expect(x[k] - p[k] == lower[k] - upper[k], "certificate: the multipliers do not balance");
  }
}

/// The squared distance of two positions.
Rational squared_distance(const std::vector<Rational>& p, const std::vector<Rational>& q) {
  Rational sum;
  for (std::size_t k = 0; k < p.size(); ++k) sum += (p[k] - q[k]) * (p[k] - q[k]);
  return sum;
}

/// Less than 0 inside, 0 on the boundary.
Rational beyond(const BallOrDisc& ball, const std::vector<Rational>& point) {
  return Rational(squared_distance(ball.center, point) - ball.radius * ball.radius);
}

void check_sphere_sphere(const Claim& claim) {
  claim.inputs({"a", "b"});
  const BallOrDisc a = ball_or_disc(claim.input["a"], "a"), b = ball_or_disc(claim.input["b"], "b");
  expect(b.axes() == a.axes(), "b: as many coordinates as a");
  claim.answers({"contact"});
  const Rational distance = squared_distance(a.center, b.center), sum(a.radius + b.radius), reach(sum * sum);
  const std::string contact = claim.word("contact"), kind = claim.kind();
  if (contact == "disjoint") {
    expect(kind == "distance", wrong_kind), claim.facts({"squared_distance"});
    expect(claim.single("squared_distance") == distance, "certificate: the squared distance is wrong");
    expect(distance > reach, "certificate: the balls are not apart");
    return;
  }
  const bool touching = contact == "touching";
  expect(touching || contact == "overlapping", "truth: contact is wrong");
  expect(touching ? kind == "tangent" || kind == "no_interior" : kind == "common_interior_point", wrong_kind);
  claim.facts({"point"});
  const std::vector<Rational> point = claim.list("point");
  expect(point.size() == a.axes(), "certificate.point: as many coordinates as the centers");
  const int in_a = sgn(beyond(a, point)), in_b = sgn(beyond(b, point));
  if (!touching) {
    expect(in_a < 0 && in_b < 0, "certificate: the point is not inside both balls");
    return;
  }
  expect(in_a <= 0 && in_b <= 0, "certificate: the point is not in both balls");
  if (kind == "tangent") {
    expect(distance == reach, "certificate: the balls are not tangent");
  } else {
    expect(sgn(a.radius) == 0 || sgn(b.radius) == 0, "certificate: both balls have an interior");
  }
}

/// True if no point of the box is nearer to p than x, a point of the box: from x, the displacement to p leads out of
/// the box on each axis on which it is not 0.
bool is_nearest(const Box& box, const std::vector<Rational>& p, const std::vector<Rational>& x) {
  for (std::size_t k = 0; k < box.axes(); ++k)
    if ((p[k] < x[k] && x[k] != box.min[k]) || (p[k] > x[k] && x[k] != box.max[k])) return false;
  return true;
}

void check_sphere_aabb(const Claim& claim) {
  claim.inputs({"sphere", "aabb"});
  const BallOrDisc ball = ball_or_disc(claim.input["sphere"], "sphere");
  const Box b = box(claim.input["aabb"], "aabb");
  expect(b.axes() == ball.axes(), "aabb: as many coordinates as sphere");
  claim.answers({"contact"});
  const std::string contact = claim.word("contact"), kind = claim.kind();
  const bool flat = kind == "flat_axis";
  if (contact == "disjoint") {
    expect(kind == "nearest_point", wrong_kind);
  } else if (contact == "touching") {
    expect(flat || kind == "tangent", wrong_kind);
  } else {
    expect(contact == "overlapping", "truth: contact is wrong");
    expect(kind == "common_interior_point", wrong_kind);
  }
  if (flat) claim.facts({"point", "axis"});
  else claim.facts({"point"});
  const std::vector<Rational> point = point_of(claim, b);
  const int in_ball = sgn(beyond(ball, point));
  if (contact == "overlapping") {
    expect(holds_inside(b, point) && in_ball < 0, "certificate: the point is not inside both");
    return;
  }
  expect(b.holds(point), "certificate: the point is not in the box");
  if (flat) {
    expect(in_ball <= 0, "certificate: the point is not in the ball");
    const std::size_t k = axis_of(claim, b);
    expect(b.min[k] == b.max[k], "certificate: the box is not flat on the axis");
    return;
  }
  expect(is_nearest(b, ball.center, point), "certificate: a point of the box is nearer");
  if (contact == "disjoint") expect(in_ball > 0, "certificate: the point is in the ball");
  else expect(in_ball == 0, "certificate: the point is not on the boundary of the ball");
}

}  // namespace

Checks checks_of_volumes() {
  return {{"aabb_aabb", check_aabb_aabb},
          {"sphere_sphere", check_sphere_sphere},
          {"sphere_aabb", check_sphere_aabb},
          {"closest_point_on_aabb", check_closest_point_on_aabb}};
}

}  // namespace touchstone::certify
