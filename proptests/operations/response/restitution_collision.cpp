// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/restitution_collision.h"

#include "oracle/response/elastic_collision.h"
#include "proptests/impact_laws.h"
#include "robust/response/elastic_collision.h"

namespace touchstone::proptests::restitution_collision_tests {

using Row = rows::restitution_collision;

EXACT_LAW("restitution_collision: momentum is kept, the relative velocity along the normal becomes -e times that", m, v,
          n, e) {
  const ExactVelocities after = ask(asked);
  return same(momentum_of(m, after), momentum_of(m, v)) &&
         dot(after.first - after.second, n) == -e * dot(v.first - v.second, n) &&
         same(cross(after.first - v.first, n), none()) && same(cross(after.second - v.second, n), none());
}

EXACT_LAW("restitution_collision: of the relative motion's energy along the normal e^2 is left; none is ever gained", m,
          v, n, e) {
  const Rational along = dot(v.first - v.second, n), reduced = m.first * m.second / (m.first + m.second);
  const Rational lost = doubled_energy(m, v) - doubled_energy(m, ask(asked));
  return lost >= 0 && lost * dot(n, n) == (1 - e * e) * reduced * along * along;
}

ROBUST_LAW("restitution_collision: e = 1 is elastic_collision", m, v, n) {
  return equal(ask(Row::Question{m, v, n, 1}), robust::elastic_collision(m, v, n));
}

EXACT_LAW("restitution_collision: one bounce after the other multiplies e", m, v, n, e) {
  const Rational half(1, 2), product(e / 2), zero(0);
  const auto turned = [&](const ExactVelocities& w) { return ask(std::tuple(m, w, n, Rational(1))); };
  // Twice turned round: as with e / 2 and then without loss.
  return same(ask(std::tuple(m, ask(asked), n, half)), turned(ask(std::tuple(m, v, n, product)))) &&
         same(ask(std::tuple(m, ask(asked), n, zero)), ask(std::tuple(m, v, n, zero)));
}

TEST_CASE("restitution_collision: exchanged bodies, other units of mass and other observers") { impact_laws<Row>(); }

NORMAL_LAW("restitution_collision", 2)

TEST_CASE("restitution_collision: p. 70 worked by hand") {
  example<Row>({{2, 2}, {{3, 1, 0}, {-1, 0, 5}}, {1, 0, 0}, 0.5}, {{0, 1, 0}, {2, 0, 5}});
  example<Row>({{2, 2}, {{3, 1, 0}, {-1, 0, 5}}, {1, 0, 0}, 0}, {{1, 1, 0}, {1, 0, 5}});
  example<Row>({{2, 2}, {{3, 1, 0}, {-1, 0, 5}}, {1, 0, 0}, 1}, {{-1, 1, 0}, {3, 0, 5}});
  // c = 1 / 14: v1 + (9/112) n, v2 - (3/112) n
  example<Row>({{1, 3}, {{1, 0, 0}, {0, 1, 0}}, {1, 2, 3}, 0.5},
               {{Rational(121, 112), Rational(9, 56), Rational(27, 112)},
                {Rational(-3, 112), Rational(53, 56), Rational(-9, 112)}});
  example<Row>({{1, 2}, {{1, 2, 3}, {4, 2, 7}}, {0, 1, 0}, 0.25}, {{1, 2, 3}, {4, 2, 7}});
}

TEST_CASE("restitution_collision: huge, subnormal and negative zero") {
  const Rational most = exact(greatest), least = exact(tiny);
  example<Row>({{1, 1}, {{greatest, 0, 0}, {-greatest, 0, 0}}, {1, 0, 0}, 0.5},
               {{Rational(-most / 2), 0, 0}, {Rational(most / 2), 0, 0}}, "invalid");
  example<Row>({{1, 1}, {{1, 0, 0}, {0, 0, 0}}, {1, 0, 0}, tiny},
               {{Rational((1 - least) / 2), 0, 0}, {Rational((1 + least) / 2), 0, 0}});
  example<Row>({{tiny, tiny}, {{1, 0, 0}, {0, 0, 0}}, {tiny, 0, 0}, -0.0},
               {{Rational(1, 2), 0, 0}, {Rational(1, 2), 0, 0}}, "invalid");
  const auto zeros = robust::restitution_collision({1, 1}, {{-0.0, 1, -0.0}, {-0.0, -1, 0}}, {0, 1, 0}, 0);
  CHECK((plus_zero(zeros.first.x) && plus_zero(zeros.first.y) && plus_zero(zeros.second.y)));
}

CONTRACT("restitution_collision: the formula in double keeps its contract", masses, velocities, normal, e) {
  if (!moderate(masses, velocities, normal, e)) return true;
  const Motion3 v = exactly(velocities.first), w = exactly(velocities.second), n = exactly(normal);
  const Rational m1 = exact(masses.first), m2 = exact(masses.second), r = condition(v - w, n);
  const auto along = [&](const Rational& other) { return Rational(16 * other * (1 + exact(e)) / (m1 + m2) * r); };
  return within_bounds(answer.first, truth.answer.first, n, along(m2), v, 2) &&
         within_bounds(answer.second, truth.answer.second, n, along(m1), w, 2);
}

TEST_CASE("restitution_collision: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::restitution_collision_tests
