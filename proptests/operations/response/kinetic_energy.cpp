// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/response/kinetic_energy.h"

#include "oracle/response/momentum.h"
#include "proptests/body_laws.h"

namespace touchstone::proptests::kinetic_energy_tests {

using Row = rows::kinetic_energy;

TEST_CASE("kinetic_energy: bodies in any order, in other units") {
  law<Row>("any order", in_any_order);
  law<Row>("masses scale", masses_scale);
  law<Row>("velocities scale twice", [](const auto& ask, const auto& asked) {
    const auto answer = ask(asked);
    for (const int k : {1, -20, 200, -200}) {
      Bodies faster = std::get<0>(asked);
      bool possible = true;
      for (auto& [mass, velocity] : faster) {
        const auto longer_velocity = longer(velocity, k);
        possible = possible && longer_velocity;
        if (longer_velocity) velocity = *longer_velocity;
      }
      if (possible && !scaled_number(answer, ask(std::tuple(faster)), 2 * k)) return false;
    }
    return true;
  });
}

LAW("kinetic_energy: it is never negative, and 0 where all bodies rest") {
  Bodies resting = std::get<0>(asked);
  for (auto& body : resting) body.velocity = {0, -0.0, 0};
  return ask(asked) >= 0 && ask(std::tuple(resting)) == 0;
}

EXACT_LAW("kinetic_energy: another observer sees it with his velocity times the momentum, and of all mass at his",
          bodies) {
  const Motion3 shift{Rational(7, 3), Rational(-11), Rational(13, 5)}, momentum = oracle::momentum(bodies).answer;
  return ask(std::tuple(with(bodies, shift))) ==
         ask(asked) + dot(momentum, shift) + mass_of(bodies) * dot(shift, shift) / 2;
}

TEST_CASE("kinetic_energy: p. 66 worked by hand") {
  example<Row>({{{1, {1, 2, 3}}, {3, {1, 0, 0}}}}, Rational(17, 2));
  example<Row>({{{2, {3, 4, 0}}}}, 25);
  example<Row>({{{1, {1, 1, 1}}, {1, {-1, -1, -1}}}}, 3);
  example<Row>({{{7, {0, -0.0, 0}}}}, 0);
  example<Row>({{}}, 0);
}

TEST_CASE("kinetic_energy: huge, subnormal and negative zero") {
  const Rational least = exact(tiny);
  example<Row>({{{0x1p-1000, {0x1p1000, 0, 0}}}}, exact(0x1p999),
               "invalid");  // the square overflows, the energy does not
  example<Row>({{{0x1p1000, {0x1p-1000, 0, 0}}}}, exact(0x1p-1001), "rounding");
  example<Row>({{{2, {huge, 0, 0}}}}, Rational(exact(huge) * exact(huge)));  // the nearest double is infinity
  example<Row>({{{3, {0x1p-537, 0, 0}}}}, Rational(3 * least / 2));          // halfway: to the even neighbour
  CHECK(robust::kinetic_energy({{3, {0x1p-537, 0, 0}}}) == 2 * tiny);
  CHECK(robust::kinetic_energy({{1, {0x1p-537, 0, 0}}}) == 0);
  CHECK(plus_zero(robust::kinetic_energy({{1, {-0.0, -0.0, -0.0}}})));
  CHECK(robust::kinetic_energy({{greatest, {1, 0, 0}}, {greatest, {0, 1, 0}}}) == greatest);
}

TEST_CASE("kinetic_energy: ties go to the even neighbour") {
  CHECK(robust::kinetic_energy({{0x1p53, {1, 0, 0}}, {1, {0, 1, 0}}}) == 0x1p52);
  CHECK(robust::kinetic_energy({{0x1p53 + 2, {1, 0, 0}}, {1, {0, 1, 0}}}) == 0x1p52 + 2);
  CHECK(robust::kinetic_energy({{0x1p53, {1, 0, 0}}, {1, {0, 1, 0x1p-60}}}) == 0x1p52 + 1);
}

TEST_CASE("kinetic_energy: thousands of bodies") {
  const Bodies bodies = thousands_of_bodies();
  CHECK(robust::kinetic_energy(bodies) == catalogue::nearest(oracle::kinetic_energy(bodies).answer));
}

CONTRACT("kinetic_energy: the formula in double keeps its contract", bodies) {
  if (!moderate(bodies)) return true;
  return within(answer, truth.answer, Rational(bodies.size() + 4) * unit() * truth.answer);
}

TEST_CASE("kinetic_energy: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::kinetic_energy_tests
