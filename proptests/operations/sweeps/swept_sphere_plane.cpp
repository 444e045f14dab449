// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_sphere_plane.h"

#include "proptests/plane_sweep_laws.h"

namespace touchstone::proptests::swept_sphere_plane_tests {
namespace {

using Row = rows::swept_sphere_plane;
using Answer = exact_answer_t<Row>;
using oracle::Surd;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Surd& t) { return {HitRelation::hit, t}; }

/// A ball over the ground.
Row::Question over_ground(double height, double radius, double velocity) {
  return {{{3, height, -1}, radius}, {2, velocity, 5}, ground};
}

constexpr Worked<Row> worked;

}  // namespace

PLANE_SWEEP_LAWS("swept_sphere_plane", sphere)

TEST_CASE("swept_sphere_plane: p. 23's time worked by hand, from either side") {
  worked(over_ground(5, 2, -6), at(Rational(1, 2)), 5);     // 5 - 6 t = 2; 2^2 + 1^2: through the plane by 1
  worked(over_ground(-5, 2, 6), at(Rational(1, 2)), 5);     // from behind
  worked(over_ground(5, 2, -4), at(Rational(3, 4)), 3);     // 2^2 - 1^2
  worked(over_ground(5, 2, -2), misses, 5);                 // short of it: 2^2 - 3^2
  worked(over_ground(-5, 2, -3), misses, 21);               // behind the plane, and away from it: 2^2 - 5^2
  worked(over_ground(5, 2, 0), misses, 21);                 // along the ground
  worked(over_ground(5, 2, -40), at(Rational(3, 40)), 29);  // far through: the start is the nearer way out, 4 + 25
  // E = 6 + 12 + 12 + 6 = 36 of length 3 |N|: 12 away; falls by 9 a step; radius 6.
  worked({{{6, 6, 6}, 6}, {-3, -6, -6}, {{1, 2, 2}, 6}}, at(Rational(2, 3)), 27);
  // E = 3 - 4 t, |N| = sqrt(2): t = (3 - sqrt(2)) / 4; E ends at -1: 1 + 1 / 2.
  worked({{{3, 0, 0}, 1}, {-4, 0, 0}, {{1, 1, 0}, 0}}, at(Surd(Rational(3, 4), Rational(-1, 4), 2)), Rational(3, 2));
}

TEST_CASE("swept_sphere_plane: touching is a hit; a ball that meets the plane at the start is none for the formula") {
  worked(over_ground(5, 2, -3), at(Rational(1)), 0);               // at the very end
  worked(over_ground(2, 2, 1), at(Rational(0)), 0);                // it leaves: 0 / -1 is -0
  worked(over_ground(2, 2, -1), at(Rational(0)), 3);               // it goes deeper: 2^2 - 1^2
  worked(over_ground(2, 2, 0), at(Rational(0)), 0, "algorithm");   // along it: 0 / 0
  worked(over_ground(1, 2, -1), at(Rational(0)), 4, "algorithm");  // to the middle: -1
  worked(over_ground(1, 2, 5), at(Rational(0)), 3, "algorithm");   // -1 / -5: where it has left
  worked(over_ground(0, 2, 1), at(Rational(0)), 4, "algorithm");
  worked(over_ground(3, 0, -4), at(Rational(3, 4)), 1);           // a point goes through
  worked(over_ground(3, 0, -3), at(Rational(1)), 0);              // and just gets there
  worked(over_ground(0, 0, 0), at(Rational(0)), 0, "algorithm");  // in the plane: 0 / 0
}

TEST_CASE("swept_sphere_plane: rounding takes a ball beside the plane for one that touches it") {
  // 1 + 2^-60 high, radius 1.
  worked({{{1, 0, 0}, 1}, {0, 0, 0}, {{1, 0, 0}, 0x1p-60}}, misses, Rational(power_of_two(-59) + power_of_two(-120)));
  worked({{{1, 0, 0}, 1}, {1, 0, 0}, {{1, 0, 0}, 0x1p-60}}, misses, Rational(power_of_two(-59) + power_of_two(-120)),
         "rounding");  // 0 / -1
}

CONTRACT("swept_sphere_plane: the formula in double keeps its contract", sphere, v, plane) {
  return keeps_contract_of_approach(sphere, v, plane, answer, truth.answer);
}

}  // namespace touchstone::proptests::swept_sphere_plane_tests
