// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_capsule_plane.h"

#include "proptests/plane_sweep_laws.h"
#include "robust/sweeps/swept_sphere_plane.h"

namespace touchstone::proptests::swept_capsule_plane_tests {
namespace {

using Row = rows::swept_capsule_plane;
using Answer = exact_answer_t<Row>;
using oracle::Surd;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Surd& t) { return {HitRelation::hit, t}; }

/// A capsule over the ground, from one height to another.
Row::Question over_ground(double from, double to, double radius, double velocity) {
  return {{{{3, from, -1}, {7, to, 2}}, radius}, {2, velocity, 5}, ground};
}

constexpr Worked<Row> worked;

}  // namespace

PLANE_SWEEP_LAWS("swept_capsule_plane", capsule)

LAW("swept_capsule_plane: the ends may be exchanged", capsule, velocity, plane) {
  const auto& [a, b] = capsule.segment;
  return equal(ask(Row::Question{{{b, a}, capsule.radius}, velocity, plane}), ask(asked));
}

ROBUST_LAW("swept_capsule_plane: the balls around its ends are not met before it, and one is met with it", capsule,
           velocity, plane) {
  const auto& [a, b] = capsule.segment;
  const auto answer = ask(asked), of_a = robust::swept_sphere_plane({a, capsule.radius}, velocity, plane),
             of_b = robust::swept_sphere_plane({b, capsule.radius}, velocity, plane);
  for (const auto& of_end : {of_a, of_b})
    if (of_end.t && (!answer.t || *of_end.t < *answer.t)) return false;
  return equal(answer, of_a) || equal(answer, of_b) || (a != b && answer.t && *answer.t == 0);
}

TEST_CASE("swept_capsule_plane: the time of the nearer end worked by hand, from either side") {
  worked(over_ground(5, 9, 2, -6), at(Rational(1, 2)), 5);     // 5 - 6 t = 2; ends at -1 and 3: 2^2 + 1^2
  worked(over_ground(-9, -5, 2, 6), at(Rational(1, 2)), 5);    // from behind
  worked(over_ground(5, 5, 2, -4), at(Rational(3, 4)), 3);     // along its side: 2^2 - 1^2
  worked(over_ground(5, 9, 2, -3), at(Rational(1)), 0);        // at the very end
  worked(over_ground(5, 9, 2, -2), misses, 5);                 // short of it: 2^2 - 3^2
  worked(over_ground(-5, -9, 2, -3), misses, 21);              // away from it: 2^2 - 5^2
  worked(over_ground(5, 9, 2, -40), at(Rational(3, 40)), 85);  // far through: the start is the nearer way out, 4 + 81
  worked(over_ground(3, 4, 0, -4), at(Rational(3, 4)), 1);     // a segment: its end goes through, by 1
  // E = 36 and 45 of length 3 |N|: 12 and 15 away; falls by 9 a step; radius 6. The ends: 3 and 6 away.
  worked({{{{6, 6, 6}, {7, 8, 8}}, 6}, {-3, -6, -6}, {{1, 2, 2}, 6}}, at(Rational(2, 3)), 27);
  // E = 3 - 4 t and more, |N| = sqrt(2): t = (3 - sqrt(2)) / 4; E ends at -1: 1 + 1 / 2.
  worked({{{{3, 0, 0}, {3, 5, 1}}, 1}, {-4, 0, 0}, {{1, 1, 0}, 0}}, at(Surd(Rational(3, 4), Rational(-1, 4), 2)),
         Rational(3, 2));
}

TEST_CASE("swept_capsule_plane: touching is a hit, and crossing at the start; then the formula asks of a ball") {
  worked(over_ground(2, 6, 2, 1), at(Rational(0)), 0);                // it leaves: 0 / -1 is -0
  worked(over_ground(2, 2, 2, 0), at(Rational(0)), 0, "algorithm");   // along it: 0 / 0
  worked(over_ground(1, 6, 2, -1), at(Rational(0)), 4, "algorithm");  // to the middle: -1
  // It crosses the plane, and neither end is near: the nearer one comes from behind at 1/2, or never.
  worked(over_ground(-5, 9, 2, 6), at(Rational(0)), 29, "algorithm");                         // 2^2 + 5^2
  worked(over_ground(0, 3, 0, 0), at(Rational(0)), 0, "algorithm");                           // an end in the plane
  worked({{{{3, 1, 0}, {3, 1, 0}}, 2}, {0, 5, 0}, ground}, at(Rational(0)), 3, "algorithm");  // a ball
}

TEST_CASE("swept_capsule_plane: rounding, subnormal and negative zero") {
  // 1 + 2^-60 high, radius 1: rounding takes it for a touch.
  worked({{{{1, 0, 0}, {2, 0, 0}}, 1}, {1, 0, 0}, {{1, 0, 0}, 0x1p-60}}, misses,
         Rational(power_of_two(-59) + power_of_two(-120)), "rounding");  // 0 / -1
  // A subnormal number apart, on both sides.
  worked(over_ground(tiny, -tiny, 0, 0), at(Rational(0)), Rational(exact(tiny) * exact(tiny)), "algorithm");
  worked(over_ground(tiny, 2 * tiny, 0, 0), misses, Rational(exact(tiny) * exact(tiny)));
  worked(over_ground(huge, greatest, 1, -1), misses, Rational((exact(huge) - 1) * (exact(huge) - 1) - 1));
  worked(over_ground(-0.0, 1, -0.0, 1), at(Rational(0)), 0);
}

TEST_CASE("swept_capsule_plane: numbers are refused first, then the radius, then the normal") {
  const Segment3d segment{{0, 0, 0}, {1, 0, 0}};
  refused<Row>({{segment, -1}, {0, 0, 0}, {{infinity, 0, 0}, 0}}, "plane.normal[0]", "finite number");
  refused<Row>({{segment, -1}, {0, 0, 0}, {{0, 0, 0}, 0}}, "capsule.radius", "radius >= 0");
  refused<Row>({{segment, 1}, {0, 0, 0}, {{0, -0.0, 0}, 0}}, "plane.normal", "nonzero normal");
}

CONTRACT("swept_capsule_plane: the formula in double keeps its contract", capsule, v, plane) {
  const auto& [a, b] = capsule.segment;
  const HeightBound of_a(plane, a), of_b(plane, b);
  if (!of_a.certain() || !of_b.certain() || (of_a.computed < 0) != (of_b.computed < 0)) return true;
  const Rational apart = size(of_b.computed) - size(of_a.computed);
  if (abs(apart) <= of_a.error + of_b.error) return true;
  return keeps_contract_of_approach({apart > 0 ? a : b, capsule.radius}, v, plane, answer, truth.answer);
}

}  // namespace touchstone::proptests::swept_capsule_plane_tests
