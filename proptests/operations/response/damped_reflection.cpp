// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/damped_reflection.h"

#include "oracle/response/reflect_plane.h"
#include "proptests/response_laws.h"
#include "robust/response/damped_reflection.h"
#include "robust/response/reflect_plane.h"

namespace touchstone::proptests::damped_reflection_tests {

using Row = rows::damped_reflection;

EXACT_LAW("damped_reflection: what is along the normal becomes -k times that, what is across it stays", v, n, k) {
  const Motion3 after = ask(asked);
  return dot(after, n) == -k * dot(v, n) && same(cross(after - v, n), none());
}

EXACT_LAW("damped_reflection: no k up to 1 in size gains speed, and k times the opposite part is lost exactly", v, n,
          k) {
  const Motion3 after = ask(asked);
  const Rational along = dot(v, n), lost = dot(v, v) - dot(after, after);
  return lost * dot(n, n) == (1 - k * k) * along * along;
}

EXACT_LAW("damped_reflection: one bounce after the other multiplies their factors", v, n, k) {
  const Rational third(1, 3), both(-k / 3);
  return same(ask(std::tuple(ask(asked), n, third)), ask(std::tuple(v, n, both)));
}

ROBUST_LAW("damped_reflection: k = 1 is reflect_plane, k = -1 keeps every velocity", v, n) {
  return equal(ask(Row::Question{v, n, 1}), robust::reflect_plane(v, n)) && equal(ask(Row::Question{v, n, -1}), v);
}

EXACT_LAW("damped_reflection: k = 1 is exactly reflect_plane, k = -1 keeps every velocity exactly", v, n) {
  return same(ask(std::tuple(v, n, Rational(1))), oracle::reflect_plane(v, n).answer) &&
         same(ask(std::tuple(v, n, Rational(-1))), v);
}

NORMAL_LAW("damped_reflection", 1)

LAW("damped_reflection: the opposite velocity gives the opposite one", v, n, k) {
  const auto answer = ask(asked), opposite = ask(Row::Question{-1.0 * v, n, k});
  return opposite.x == -answer.x && opposite.y == -answer.y && opposite.z == -answer.z;
}

TEST_CASE("damped_reflection: p. 71's bounces worked by hand") {
  const Rational k = exact(0.8);
  example<Row>({{3, -5, 2}, {0, 1, 0}, 0.8}, {3, Rational(5 * k), 2});
  // u = (2, 2, 2), w = (-1, 0, 1)
  example<Row>({{1, 2, 3}, {1, 1, 1}, 0.5}, {-2, -1, 0});
  example<Row>({{1, 2, 3}, {1, 1, 1}, 0}, {-1, 0, 1});
  example<Row>({{1, 2, 3}, {1, 1, 1}, -1}, {1, 2, 3});
  example<Row>({{1, 2, 3}, {1, 1, 1}, 3}, {-7, -6, -5});
  example<Row>({{2, -1, 0}, {1, 2, 0}, 0.8}, {2, -1, 0});  // along the plane
}

TEST_CASE("damped_reflection: huge, subnormal and negative zero") {
  const Rational most = exact(greatest), least = exact(tiny);
  example<Row>({{1, 0, 0}, {1, 1, 0}, tiny}, {Rational((1 - least) / 2), Rational(-(1 + least) / 2), 0});
  example<Row>({{greatest, 1, 0}, {1, 0, 0}, 0.5}, {Rational(-most / 2), 1, 0});
  example<Row>({{2, 1, 0}, {1, 0, 0}, greatest}, {Rational(-2 * most), 1, 0});  // the nearest double is -infinity
  example<Row>({{1, 1, 0}, {tiny, 0, 0}, -0.0}, {0, 1, 0}, "invalid");
  CHECK(plus_zero(robust::damped_reflection({-0.0, 1, 0}, {0, 1, 0}, 0.8).x));
  CHECK(plus_zero(robust::damped_reflection({5, 1, 0}, {1, 0, 0}, -0.0).x));
}

CONTRACT("damped_reflection: the formula in double keeps its contract", v, n, k) {
  if (!moderate(v, n, k)) return true;
  const Motion3 velocity = exactly(v), normal = exactly(n);
  const Rational along = 11 * (1 + size(k)) * condition(velocity, normal);
  return within_bounds(answer, truth.answer, normal, along, velocity, 3);
}

TEST_CASE("damped_reflection: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::damped_reflection_tests
