// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/ray_sphere.h"

#include "proptests/passage_laws.h"
#include "robust/sweeps/swept_sphere_sphere.h"

namespace touchstone::proptests::ray_sphere_tests {

using Row = rows::ray_sphere;
using InPlane = Row::InPlane;
using InSpace = Row::InSpace;
using namespace surd_passages;

constexpr Worked<Row> worked;
constexpr Circle2d disc{{0, 0}, 5};
constexpr Sphere3d ball{{0, 0, 0}, 2};

BALL_PASSAGE_LAWS("ray_sphere", "ray")
DIRECTION_PASSAGE_LAW("ray_sphere")

ROBUST_LAW("ray_sphere: a point that moves with the direction first meets the ball at first, if that is not after 1",
           ray, ball) {
  const auto [origin, direction] = in_space(ray);
  const auto swept = robust::swept_sphere_sphere({origin, 0}, in_space(ball), direction, {0, 0, 0});
  const auto answer = ask(asked);
  if (swept.relation == HitRelation::never) return answer.relation == Relation::none || *answer.first >= 1;
  return answer.first == swept.t;
}

TEST_CASE("ray_sphere: both roots worked by hand; margin: |f| where it is least") {
  worked(InPlane{{{-6, 3}, {2, 0}}, disc}, from_to(Rational(1), Rational(5)), 16);  // (2 t - 6)^2 = 16; 0 - 16
  // (t - 3)^2 + 1 = 4: t = 3 -+ sqrt(3); the least is 1 - 4.
  worked(InSpace{{{-3, 1, 0}, {1, 0, 0}}, ball}, from_to(Surd(3, -1, 3), Surd(3, 1, 3)), 3);
  worked(InSpace{{{-3, 2, 0}, {1, 0, 0}}, ball}, from_to(Rational(3), Rational(3)), 0);  // tangent
  worked(InSpace{{{-3, 3, 0}, {1, 0, 0}}, ball}, none, 5);                               // past it: 9 - 4
  worked(InSpace{{{-3, 1, 0}, {-1, 0, 0}}, ball}, none, 6);                              // away: 10 - 4
  // p = -3 (1, 2, 2), v = (1, 2, 2), r = 3: |t - 3| 3 = 3.
  worked(InSpace{{{-3, -6, -6}, {1, 2, 2}}, {{0, 0, 0}, 3}}, from_to(Rational(2), Rational(4)), 9);
}

TEST_CASE("ray_sphere: a ray that starts in the ball has met it") {
  worked(InSpace{{{0, 1, 0}, {1, 0, 0}}, ball}, from_to(Rational(0), Surd(0, 1, 3)), 3);
  worked(InSpace{{{1, 0, 0}, {2, 0, 0}}, ball}, from_to(Rational(0), Rational(1, 2)), 3);
  worked(InSpace{{{2, 0, 0}, {1, 0, 0}}, ball}, from_to(Rational(0), Rational(0)), 0);   // touching, away
  worked(InSpace{{{2, 0, 0}, {-1, 0, 0}}, ball}, from_to(Rational(0), Rational(4)), 4);  // touching, through
  worked(InSpace{{{2, 0, 0}, {0, 1, 0}}, ball}, from_to(Rational(0), Rational(0)), 0);   // touching, along
}

TEST_CASE("ray_sphere: a ball of radius 0 is a point") {
  worked(InPlane{{{-2, -1}, {4, 2}}, {{0, 0}, 0}}, from_to(Rational(1, 2), Rational(1, 2)), 0);
  worked(InPlane{{{0, 0}, {4, 2}}, {{0, 0}, -0.0}}, from_to(Rational(0), Rational(0)), 0);
  worked(InPlane{{{-2, -1}, {1, 0}}, {{0, 0}, 0}}, none, 1);
}

TEST_CASE("ray_sphere: rounding sees a hit far from the line, and loses one at its side") {
  // It passes at 2, the radius is 1; p . p and C are 2^60.
  worked(InSpace{{{-0x1p30, 2, 0}, {0x1p31, 0, 0}}, {{0, 0, 0}, 1}}, none, 3, "rounding");
}

CONTRACT("ray_sphere: the formula in double keeps its contract", ray, ball) {
  const Rational q = squared_distance(ray.origin, ball.center) + exact(ball.radius) * exact(ball.radius);
  const Rational speed = squared_distance(ray.direction, std::decay_t<decltype(ray.direction)>{});
  return roots_keep(truth, answer, ray.origin - ball.center, ray.direction, ball.radius, q, speed, false);
}

TEST_CASE("ray_sphere: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::ray_sphere_tests
