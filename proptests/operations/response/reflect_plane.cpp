// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/reflect_plane.h"

#include "proptests/response_laws.h"
#include "robust/response/reflect_plane.h"
#include "robust/response/reflect_wall.h"

namespace touchstone::proptests::reflect_plane_tests {

using Row = rows::reflect_plane;

EXACT_LAW("reflect_plane: reflected twice, every velocity is what it was; speed is kept", v, n) {
  const Motion3 after = ask(asked);
  return same(ask(std::tuple(after, n)), v) && dot(after, after) == dot(v, v);
}

EXACT_LAW("reflect_plane: what is along the normal is turned round, what is across it stays", v, n) {
  const Motion3 after = ask(asked);
  return dot(after, n) == -dot(v, n) && same(cross(after - v, n), none()) &&
         same(ask(std::tuple(n, n)), Rational(-1) * n);
}

NORMAL_LAW("reflect_plane", 1)

LAW("reflect_plane: the opposite velocity is reflected to the opposite one, and velocities scale", v, n) {
  const auto answer = ask(asked), opposite = ask(Row::Question{-1.0 * v, n});
  if (opposite.x != -answer.x || opposite.y != -answer.y || opposite.z != -answer.z) return false;
  for (const int k : {1, -30, 400, -400}) {
    const auto faster = longer(v, k);
    if (faster && !scaled_vector(answer, ask(Row::Question{*faster, n}), k)) return false;
  }
  return true;
}

ROBUST_LAW("reflect_plane: across an axis it is reflect_wall", v) {
  return equal(ask(Row::Question{v, {3, 0, -0.0}}), robust::reflect_wall(v, Axis::x)) &&
         equal(ask(Row::Question{v, {0, -tiny, 0}}), robust::reflect_wall(v, Axis::y)) &&
         equal(ask(Row::Question{v, {0, 0, greatest}}), robust::reflect_wall(v, Axis::z));
}

TEST_CASE("reflect_plane: p. 68's planes worked by hand") {
  example<Row>({{3, -4, 5}, {0, 1, 0}}, {3, 4, 5});
  example<Row>({{1, 0, 0}, {1, 1, 0}}, {0, -1, 0});  // u = (1/2, 1/2, 0), w = (1/2, -1/2, 0)
  example<Row>({{1, 2, 3}, {1, -1, 0}}, {2, 1, 3});
  // v . n = 6, n . n = 3: u = (2, 2, 2), w = (-1, 0, 1)
  example<Row>({{1, 2, 3}, {1, 1, 1}}, {-3, -2, -1});
  // v . n = 9, n . n = 9: u = n
  example<Row>({{5, 2, 0}, {1, 2, 2}}, {3, -2, -4});
  // v . n = 4, n . n = 14: u = (2/7) n
  example<Row>({{1, 0, 1}, {1, 2, 3}}, {Rational(3, 7), Rational(-8, 7), Rational(-5, 7)});
  example<Row>({{2, -1, 0}, {1, 2, 0}}, {2, -1, 0});  // along the plane
  example<Row>({{0, 0, 0}, {1, 2, 3}}, {0, 0, 0});
}

TEST_CASE("reflect_plane: huge, subnormal and negative zero") {
  const Rational least = exact(tiny), most = exact(greatest);
  example<Row>({{tiny, 0, 0}, {1, 1, 0}}, {0, Rational(-least), 0});
  example<Row>({{3, -4, 5}, {0, tiny, 0}}, {3, 4, 5}, "invalid");  // 0 / 0
  example<Row>({{3, -4, 5}, {huge, huge, 0}}, {4, -3, 5}, "invalid");
  example<Row>({{greatest, greatest, 0}, {1, 0, 0}}, {Rational(-most), most, 0});
  // v . n is the greatest number, n . n is 5
  example<Row>({{greatest, greatest, 0}, {2, -1, 0}}, {Rational(most / 5), Rational(most * 7 / 5), 0}, "invalid");
  CHECK(robust::reflect_plane({greatest, greatest, 0}, {2, -1, 0}).y == infinity);
  CHECK(plus_zero(robust::reflect_plane({-0.0, 1, -0.0}, {-0.0, 1, 0}).x));
  CHECK(plus_zero(robust::reflect_plane({1, 1, -0.0}, {1, 0, 0}).z));
}

TEST_CASE("reflect_plane: ties go to the even neighbour") {
  // For n = (3, 4, 0) x' is (7 x - 24 y) / 25, here 7 * 292457036391567 + 24 * 290000000000001 = 2^53 + 1.
  CHECK(robust::reflect_plane({25.0 * 292457036391567, -25.0 * 290000000000001, 0}, {3, 4, 0}).x == 0x1p53);
  const auto thirds = robust::reflect_plane({1, 1, 2}, {1, 1, 1});
  CHECK(thirds.x == -0x1.aaaaaaaaaaaabp+0);  // 1 - 8/3
  CHECK(thirds.z == -0x1.5555555555555p-1);  // 2 - 8/3
}

CONTRACT("reflect_plane: the formula in double keeps its contract", v, n) {
  if (!moderate(v, n)) return true;
  const Motion3 velocity = exactly(v), normal = exactly(n);
  return within_bounds(answer, truth.answer, normal, Rational(20 * condition(velocity, normal)), velocity, 3);
}

TEST_CASE("reflect_plane: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::reflect_plane_tests
