// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/segment_sphere.h"

#include "proptests/passage_laws.h"
#include "robust/sweeps/swept_sphere_sphere.h"

namespace touchstone::proptests::segment_sphere_tests {

using Row = rows::segment_sphere;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;
using namespace surd_passages;

constexpr Worked<Row> worked;
constexpr Circle2d disc{{0, 0}, 5};
constexpr Sphere3d ball{{0, 0, 0}, 2};

BALL_PASSAGE_LAWS("segment_sphere", "segment")
REVERSED_PASSAGE_LAW("segment_sphere")

ROBUST_LAW("segment_sphere: a point that moves along the segment first meets the ball at first", segment, ball) {
  const auto [a, b] = in_space(segment);
  // The velocities differ by b - a, exactly.
  const auto swept = robust::swept_sphere_sphere({a, 0}, in_space(ball), {b.x, b.y, b.z}, {a.x, a.y, a.z});
  const auto answer = ask(asked);
  return (swept.relation == HitRelation::hit) == (answer.relation == Relation::hit) && swept.t == answer.first;
}

TEST_CASE("segment_sphere: both roots worked by hand; margin: |f| where it is least") {
  worked(InPlane{{{-6, 3}, {6, 3}}, disc}, from_to(Rational(1, 6), Rational(5, 6)), 16);
  // (3 t - 3)^2 + 1 = 4: t = 1 - sqrt(3) / 3; it ends in the ball, at 1 - 4.
  worked(InSpace{{{-3, 1, 0}, {0, 1, 0}}, ball}, from_to(Surd(1, Rational(-1, 3), 3), Rational(1)), 3);
  worked(InSpace{{{-3, 2, 0}, {3, 2, 0}}, ball}, from_to(Rational(1, 2), Rational(1, 2)), 0);  // tangent
  worked(InSpace{{{-3, 3, 0}, {3, 3, 0}}, ball}, none, 5);                                     // past it: 9 - 4
  worked(InSpace{{{-4, 0, 0}, {-3, 0, 0}}, ball}, none, 5);                                    // short of it: 9 - 4
  worked(InSpace{{{-4, 0, 0}, {-5, 0, 0}}, ball}, none, 12);                                   // away
}

TEST_CASE("segment_sphere: ends in the ball and on its boundary") {
  worked(InSpace{{{0, 1, 0}, {1, 0, 0}}, ball}, from_to(Rational(0), Rational(1)), Rational(7, 2));  // within
  worked(InSpace{{{0, 1, 0}, {4, 1, 0}}, ball}, from_to(Rational(0), Surd(0, Rational(1, 4), 3)), 3);
  worked(InSpace{{{-4, 0, 0}, {-2, 0, 0}}, ball}, from_to(Rational(1), Rational(1)), 0);
  worked(InSpace{{{2, 0, 0}, {4, 0, 0}}, ball}, from_to(Rational(0), Rational(0)), 0);
  worked(InSpace{{{2, 0, 0}, {-2, 0, 0}}, ball}, from_to(Rational(0), Rational(1)), 4);
}

TEST_CASE("segment_sphere: a segment of length zero is a point, and so is a ball of radius 0") {
  worked(InSpace{{{1, 0, 0}, {1, 0, 0}}, ball}, from_to(Rational(0), Rational(0)), 3, "algorithm");
  worked(InSpace{{{2, 0, 0}, {2, 0, 0}}, ball}, from_to(Rational(0), Rational(0)), 0, "algorithm");
  worked(InSpace{{{3, 0, 0}, {3, 0, 0}}, ball}, none, 5);
  worked(InPlane{{{1, 1}, {1, 1}}, {{1, 1}, -0.0}}, from_to(Rational(0), Rational(0)), 0, "algorithm");
  worked(InPlane{{{-2, -1}, {2, 1}}, {{0, 0}, 0}}, from_to(Rational(1, 2), Rational(1, 2)), 0);
}

TEST_CASE("segment_sphere: rounding sees a hit far from the line") {
  worked(InSpace{{{-0x1p30, 2, 0}, {0x1p30, 2, 0}}, {{0, 0, 0}, 1}}, none, 3, "rounding");
}

CONTRACT("segment_sphere: the formula in double keeps its contract", segment, ball) {
  const auto& [a, b] = segment;
  const Rational q = squared_distance(a, ball.center) + exact(ball.radius) * exact(ball.radius);
  return roots_keep(truth, answer, a - ball.center, b - a, ball.radius, q, squared_distance(a, b), true);
}

}  // namespace touchstone::proptests::segment_sphere_tests
