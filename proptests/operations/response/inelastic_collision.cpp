// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/inelastic_collision.h"

#include "proptests/impact_laws.h"

namespace touchstone::proptests::inelastic_collision_tests {

using Row = rows::inelastic_collision;

EXACT_LAW("inelastic_collision: momentum is kept, and the energy of the relative motion is lost", m, v) {
  const Motion3 together = ask(asked), apart = v.first - v.second;
  const ExactVelocities after{together, together};
  const Rational reduced = m.first * m.second / (m.first + m.second);
  return same(momentum_of(m, after), momentum_of(m, v)) &&
         doubled_energy(m, v) - doubled_energy(m, after) == reduced * dot(apart, apart);
}

EXACT_LAW("inelastic_collision: the velocity is between those before, nearer to the heavier body's", m, v) {
  const Motion3 together = ask(asked);
  return same(m.first * (together - v.first), m.second * (v.second - together));
}

TEST_CASE("inelastic_collision: exchanged bodies, other units of mass and other observers") { impact_laws<Row>(); }

ROBUST_LAW("inelastic_collision: equal velocities stay what they are", m, v) {
  return equal(ask(Row::Question{m, {v.first, v.first}}), v.first);
}

TEST_CASE("inelastic_collision: p. 70 worked by hand") {
  example<Row>({{1, 3}, {{1, 0, 0}, {0, 1, 0}}}, {Rational(1, 4), Rational(3, 4), 0});
  example<Row>({{2, 2}, {{5, -1, 0}, {-5, 2, 3}}}, {0, Rational(1, 2), Rational(3, 2)});
  example<Row>({{2, 3}, {{3, -6, 9}, {-2, 4, -6}}}, {0, 0, 0});
  example<Row>({{1, 2}, {{1, 1, 1}, {2, 2, 2}}}, {Rational(5, 3), Rational(5, 3), Rational(5, 3)});
}

TEST_CASE("inelastic_collision: huge, subnormal and negative zero") {
  const Rational most = exact(greatest), least = exact(tiny);
  example<Row>({{2, 2}, {{greatest, greatest, 0}, {greatest, -greatest, 0}}}, {most, 0, 0}, "invalid");
  example<Row>({{greatest, greatest}, {{1, 2, 3}, {3, 2, 1}}}, {2, 2, 2}, "invalid");
  example<Row>({{tiny, tiny}, {{1, 0, 3}, {0, 0.5, 1}}}, {Rational(1, 2), Rational(1, 4), 2}, "rounding");
  example<Row>({{1, 1}, {{tiny, 0, 0}, {0, 3 * tiny, 0}}}, {Rational(least / 2), Rational(3 * least / 2), 0});
  CHECK(plus_zero(robust::inelastic_collision({1, 1}, {{-0.0, 1, 0}, {-0.0, -1, 0}}).x));
  CHECK(plus_zero(robust::inelastic_collision({1, 1}, {{-0.0, 1, 0}, {-0.0, -1, 0}}).y));
}

TEST_CASE("inelastic_collision: ties go to the even neighbour") {
  const auto found = robust::inelastic_collision({1, 1}, {{0x1p53, 0x1p53 + 2, -0x1p53}, {0x1p53 + 2, 0x1p53 + 4, 0}});
  CHECK(found.x == 0x1p53);      // between 2^53 and 2^53 + 2
  CHECK(found.y == 0x1p53 + 4);  // between 2^53 + 2 and 2^53 + 4
  CHECK(found.z == -0x1p52);
}

CONTRACT("inelastic_collision: the formula in double keeps its contract", masses, velocities) {
  if (!moderate(masses, velocities)) return true;
  const Rational m1 = exact(masses.first), m2 = exact(masses.second);
  const auto kept = [&](double found, const Rational& exactly, double v, double w) {
    return within(found, exactly, 5 * unit() * (m1 * size(v) + m2 * size(w)) / (m1 + m2));
  };
  const auto& [v, w] = velocities;
  return kept(answer.x, truth.answer.x, v.x, w.x) && kept(answer.y, truth.answer.y, v.y, w.y) &&
         kept(answer.z, truth.answer.z, v.z, w.z);
}

TEST_CASE("inelastic_collision: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::inelastic_collision_tests
