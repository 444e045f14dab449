// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/elastic_collision.h"

#include "proptests/impact_laws.h"

namespace touchstone::proptests::elastic_collision_tests {

using Row = rows::elastic_collision;

EXACT_LAW("elastic_collision: momentum and energy are kept, the relative velocity along the normal is turned round", m,
          v, n) {
  const ExactVelocities after = ask(asked);
  return same(momentum_of(m, after), momentum_of(m, v)) && doubled_energy(m, after) == doubled_energy(m, v) &&
         dot(after.first - after.second, n) == -dot(v.first - v.second, n);
}

EXACT_LAW("elastic_collision: what is across the normal stays, and a second bounce undoes the first", m, v, n) {
  const ExactVelocities after = ask(asked);
  return same(cross(after.first - v.first, n), none()) && same(cross(after.second - v.second, n), none()) &&
         same(ask(std::tuple(m, after, n)), v);
}

TEST_CASE("elastic_collision: exchanged bodies, other units of mass and other observers") { impact_laws<Row>(); }

NORMAL_LAW("elastic_collision", 2)

ROBUST_LAW("elastic_collision: bodies of one mass exchange what they have along the normal", m, v) {
  const auto found = ask(Row::Question{{m.first, m.first}, v, {0, 1, 0}});
  return equal(found, Velocitiesd{{v.first.x, v.second.y, v.first.z}, {v.second.x, v.first.y, v.second.z}});
}

EXACT_LAW("elastic_collision: the heavier the other body, the nearer to a bounce off a plane that moves with it", m, v,
          n) {
  const Motion3 apart = v.first - v.second;
  const Motion3 part = Rational(dot(apart, n) / dot(n, n)) * n;
  const Motion3 off_a_wall = v.first - Rational(2) * part;
  const ExactVelocities after = ask(asked);
  const Rational lighter = m.first / (m.first + m.second);
  return same(after.first - off_a_wall, Rational(2 * lighter) * part) &&
         same(after.second - v.second, Rational(2 * lighter) * part);
}

TEST_CASE("elastic_collision: p. 69 worked by hand") {
  example<Row>({{2, 2}, {{3, 1, 0}, {-1, 0, 5}}, {1, 0, 0}}, {{-1, 1, 0}, {3, 0, 5}});
  // c = 1 / 14: v1 + (3/28) n, v2 - (1/28) n
  example<Row>({{1, 3}, {{1, 0, 0}, {0, 1, 0}}, {1, 2, 3}}, {{Rational(31, 28), Rational(3, 14), Rational(9, 28)},
                                                             {Rational(-1, 28), Rational(13, 14), Rational(-3, 28)}});
  // At rest: v1' = (m1 - m2) / (m1 + m2) v1, v2' = 2 m1 / (m1 + m2) v1
  example<Row>({{1, 2}, {{3, 0, 0}, {0, 0, 0}}, {-5, 0, 0}}, {{-1, 0, 0}, {2, 0, 0}});
  example<Row>({{1, 2}, {{1, 0, 0}, {-1, 0, 0}}, {1, 0, 0}}, {{Rational(-5, 3), 0, 0}, {Rational(1, 3), 0, 0}});
  example<Row>({{1, 2}, {{-1, 0, 0}, {1, 0, 0}}, {1, 0, 0}},
               {{Rational(5, 3), 0, 0}, {Rational(-1, 3), 0, 0}});  // they part: the law is the same
  example<Row>({{1, 2}, {{1, 2, 3}, {4, 2, 7}}, {0, 1, 0}}, {{1, 2, 3}, {4, 2, 7}});
}

TEST_CASE("elastic_collision: huge, subnormal and negative zero") {
  const Rational most = exact(greatest);
  example<Row>({{1, 1}, {{greatest, 0, 0}, {-greatest, 0, 0}}, {1, 0, 0}}, {{Rational(-most), 0, 0}, {most, 0, 0}},
               "invalid");
  example<Row>({{tiny, tiny}, {{1, 0, 0}, {0, 0, 0}}, {tiny, 0, 0}}, {{0, 0, 0}, {1, 0, 0}}, "invalid");
  // A body as heavy as 2^900 of the other is a wall: 3 + 2^-898 less, and so on.
  const auto off_a_wall = robust::elastic_collision({1, 0x1p900}, {{3, 1, 2}, {0, 0, 0}}, {1, 0, 0});
  CHECK((off_a_wall.first.x == -3 && off_a_wall.second.x == 6 * 0x1p-900));
  const auto beyond = robust::elastic_collision({3, 1}, {{greatest, 0, 0}, {0, 0, 0}}, {1, 0, 0});
  CHECK((beyond.first.x == greatest / 2 && beyond.second.x == infinity));
  const auto zeros = robust::elastic_collision({1, 1}, {{-0.0, 1, -0.0}, {-0.0, 0, 0}}, {0, 1, 0});
  CHECK((plus_zero(zeros.first.x) && plus_zero(zeros.first.y) && plus_zero(zeros.second.x)));
}

CONTRACT("elastic_collision: the formula in double keeps its contract", masses, velocities, normal) {
  if (!moderate(masses, velocities, normal)) return true;
  const Motion3 v = exactly(velocities.first), w = exactly(velocities.second), n = exactly(normal);
  const Rational m1 = exact(masses.first), m2 = exact(masses.second), r = condition(v - w, n);
  const auto along = [&](const Rational& other) { return Rational(14 * 2 * other / (m1 + m2) * r); };
  return within_bounds(answer.first, truth.answer.first, n, along(m2), v, 2) &&
         within_bounds(answer.second, truth.answer.second, n, along(m1), w, 2);
}

TEST_CASE("elastic_collision: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::elastic_collision_tests
