// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/penalty_force.h"

#include "proptests/response_laws.h"
#include "robust/planes/point_plane.h"

namespace touchstone::proptests::penalty_force_tests {
namespace {

using Row = rows::penalty_force;

Rational height_over(const Plane<Rational>& plane, const Point3<Rational>& p) {
  return Rational(dot(plane.normal, Motion3{p.x, p.y, p.z}) + plane.offset);
}

}  // namespace

EXACT_LAW("penalty_force: behind the plane, and only there, -(k E + c v . N) is the force times the normal", p, v,
          plane, k, c) {
  const Motion3 force = ask(asked);
  const Rational height = height_over(plane, p);
  if (sgn(height) >= 0) return same(force, none());
  return dot(force, plane.normal) == -(k * height + c * dot(v, plane.normal)) &&
         same(cross(force, plane.normal), none());
}

ROBUST_LAW("penalty_force: in front of the plane and on it there is no force", p, v, plane) {
  const bool behind = robust::point_plane_side(plane, p) == PlaneSide::back;
  return behind || equal(ask(asked), Vector3d{0, 0, 0});
}

EXACT_LAW("penalty_force: spring and damper add up; a damper of 1 alone leaves the velocity across the normal", p, v,
          plane, k, c) {
  const Rational zero(0), one(1);
  const Motion3 spring = ask(std::tuple(p, v, plane, k, zero)), damper = ask(std::tuple(p, v, plane, zero, c)),
                held = ask(std::tuple(p, v, plane, zero, one));
  if (!same(ask(asked), spring + damper) || !same(ask(std::tuple(p, none(), plane, k, c)), spring)) return false;
  return sgn(height_over(plane, p)) >= 0 ? same(held, none()) : sgn(Rational(dot(v + held, plane.normal))) == 0;
}

EQUATION_LAW("penalty_force", 2)

LAW("penalty_force: exchanges of the axes exchange the components") {
  const auto answer = ask(asked);
  return std::all_of(axis_maps.begin(), axis_maps.end(),
                     [&](const AxisMap& map) { return equal(ask(map(asked)), map(answer)); });
}

LAW("penalty_force: stiffness and damping in other units", p, v, plane, k, c) {
  const auto answer = ask(asked);
  for (const int j : {1, -30, 400, -400}) {
    const auto other = longer({k, c, 0}, j);
    if (other && !scaled_vector(answer, ask(Row::Question{p, v, plane, other->x, other->y}), j)) return false;
  }
  return true;
}

EXACT_LAW("penalty_force: the whole may be moved", p, v, plane, k, c) {
  const Motion3 step{Rational(7, 3), Rational(-11), Rational(13, 5)};
  const Plane<Rational> moved{plane.normal, Rational(plane.offset - dot(plane.normal, step))};
  return same(ask(std::tuple(p + step, v, moved, k, c)), ask(asked));
}

TEST_CASE("penalty_force: p. 72-73 worked by hand") {
  const Plane3d ground{{0, 1, 0}, 0};
  example<Row>({{5, -2, 7}, {1, 0, 0}, ground, 3, 10}, {0, 6, 0});    // the spring alone
  example<Row>({{5, -2, 7}, {1, -1, 0}, ground, 3, 10}, {0, 16, 0});  // on the way in
  example<Row>({{5, -2, 7}, {1, 1, 0}, ground, 3, 10}, {0, -4, 0});   // on the way out the damper holds it back
  example<Row>({{5, 0, 7}, {1, -1, 0}, ground, 3, 10}, {0, 0, 0});    // on the plane
  example<Row>({{5, 2, 7}, {1, -1, 0}, ground, 3, 10}, {0, 0, 0});
  example<Row>({{0, -2, 0}, {0, -1, 0}, {{0, 7, 0}, 0}, 3, 10}, {0, 16, 0});
  // N . N = 9, E = -18, v . N = 3: (2 * 18 - 5 * 3) / 9 = 7/3
  example<Row>({{1, 1, 0}, {1, 1, 0}, {{1, 2, -2}, -21}, 2, 5}, {Rational(7, 3), Rational(14, 3), Rational(-14, 3)});
  example<Row>({{1, 1, 0}, {1, 1, 0}, {{1, 2, -2}, -21}, -1, 0}, {-2, -4, 4});
}

TEST_CASE("penalty_force: rounding, huge, subnormal and negative zero") {
  const Rational least = exact(tiny);
  example<Row>({{0, -tiny, 0}, {0, 0, 0}, {{0, 1, 0}, 0}, 1, 0}, {0, least, 0});
  example<Row>({{0, -tiny, 0}, {0, -1, 0}, {{0, tiny, 0}, 0}, 0, 2}, {0, 2, 0}, "rounding");  // E and N . N underflow
  example<Row>({{0, -1, 0}, {0, 0, 0}, {{0, greatest, 0}, 0}, 3, 0}, {0, 3, 0}, "invalid");
  CHECK(robust::penalty_force({0, -greatest, 0}, {0, 0, 0}, {{0, 1, 0}, 0}, 2, 0).y == infinity);
  // As doubles 0.1 + 0.2 is 2^-55 more than 0.3.
  example<Row>({{0.1, 0.2, 0}, {0, -1, 0}, {{1, 1, 0}, -0.3}, 1, 1}, {0, 0, 0});
  const auto zeros = robust::penalty_force({-0.0, 1, -0.0}, {-0.0, -1, 0}, {{-0.0, 1, 0}, 0}, 1, 1);
  CHECK((plus_zero(zeros.x) && plus_zero(zeros.y) && plus_zero(zeros.z)));
  const auto along = robust::penalty_force({0, -1, 0}, {0, 0, 0}, {{-0.0, 1, 0}, 0}, 1, 1);
  CHECK((plus_zero(along.x) && along.y == 1 && plus_zero(along.z)));
}

CONTRACT("penalty_force: the formula in double keeps its contract", p, v, plane, k, c) {
  if (!moderate(p, v, plane, k, c)) return true;
  const Motion3 n = exactly(plane.normal), at = exactly(Vector3d{p.x, p.y, p.z}), velocity = exactly(v);
  const Rational square = dot(n, n), of_height = condition(at, n) * square + abs(exact(plane.offset)),
                 height = dot(at, n) + exact(plane.offset);
  if (abs(height) <= 5 * unit() * of_height) return true;
  const Rational force = abs(exact(k)) * of_height / square + abs(exact(c)) * condition(velocity, n);
  return within_bounds(answer, truth.answer, n, Rational(12 * force), velocity, 0);
}

TEST_CASE("penalty_force: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::penalty_force_tests
