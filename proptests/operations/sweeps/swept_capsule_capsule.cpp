// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/sweeps/swept_capsule_capsule.h"

#include "proptests/motion_laws.h"
#include "proptests/round_laws.h"
#include "robust/mixed/capsule_capsule.h"
#include "robust/sweeps/swept_sphere_sphere.h"

namespace touchstone::proptests::swept_capsule_capsule_tests {
namespace {

using Row = rows::swept_capsule_capsule;
using Answer = exact_answer_t<Row>;
using oracle::Surd;

const Answer misses{HitRelation::never, std::nullopt};
Answer at(const Surd& t) { return {HitRelation::hit, t}; }

/// Along x, from -4 to 4, and along y through the origin.
constexpr Capsule3d bar(double radius) { return {{{-4, 0, 0}, {4, 0, 0}}, radius}; }
constexpr Capsule3d across(double z, double radius) { return {{{0, -4, z}, {0, 4, z}}, radius}; }
constexpr Capsule3d ball(const Point3d& p, double radius) { return {{p, p}, radius}; }
constexpr Worked<Row> worked;

}  // namespace

VELOCITIES_LAW("swept_capsule_capsule", 2)

LAW("swept_capsule_capsule: ends and radii may be exchanged, and the capsules if a moves back", a, b, velocity) {
  const auto answer = ask(asked);
  const Capsule3d with_r{b.segment, a.radius}, with_s{a.segment, b.radius};
  return equal(ask(Row::Question{rewritten(a)[0], b, velocity}), answer) &&
         equal(ask(Row::Question{a, rewritten(b)[0], velocity}), answer) &&
         equal(ask(Row::Question{with_s, with_r, velocity}), answer) &&
         equal(ask(Row::Question{b, a, -1.0 * velocity}), answer);
}

ROBUST_LAW("swept_capsule_capsule: at rest it is capsule_capsule, and capsules that meet then do so at the start", a, b,
           velocity) {
  const bool meet = robust::capsule_capsule(a, b) != Contact::disjoint;
  const auto rest = ask(Row::Question{a, b, {0, 0, 0}}), answer = ask(asked);
  return rest.t.has_value() == meet && (!meet || (*rest.t == 0 && answer.t == 0));
}

ROBUST_LAW("swept_capsule_capsule: no two ends meet before it, and capsules of one point are balls", a, b, velocity) {
  const auto answer = ask(asked);
  for (const Sphere3d& of_a : balls_in(a))
    for (const Sphere3d& of_b : balls_in(b)) {
      const auto balls = robust::swept_sphere_sphere(of_a, of_b, velocity, {0, 0, 0});
      if (balls.t && (!answer.t || *balls.t < *answer.t)) return false;
      const Row::Question points{ball(of_a.center, a.radius), ball(of_b.center, b.radius), velocity};
      if (!equal(ask(points), balls)) return false;
    }
  return true;
}

TEST_CASE("swept_capsule_capsule: to the side, an end and between, worked by hand") {
  // 6 - 8 t = 2; the path has to be moved by 2 to end above b: 2^2 + 2^2
  worked({across(6, 1), bar(1), {0, 0, -8}}, at(Rational(1, 2)), 8);
  worked({across(-6, 1), bar(1), {0, 0, 8}}, at(Rational(1, 2)), 8);  // from the other side
  worked({across(6, 1), bar(1), {0, 0, -3}}, misses, 5);              // short of it: 3^2 - 2^2
  worked({across(6, 1), bar(1), {0, 0, 3}}, misses, 32);              // away: 6^2 - 2^2
  // In a plane, an end of a comes to the side of b: 8 - 10 t = 3; moved by any height, a would pass
  worked({{{{1, 8, 0}, {1, 12, 0}}, 1}, bar(2), {0, -10, 0}}, at(Rational(1, 2)), 9);
  worked({{{{-9, 0, 6}, {0, 0, 6}}, 1}, bar(1), {0, 0, -8}}, at(Rational(1, 2)), 4);  // side by side: 6 - 8 t = 2
  // End to end by (2, 4, 4) (1 - t), which is 6 (1 - t) long
  worked({{{{6, 4, 4}, {9, 9, 4}}, 1}, bar(2), {-2, -4, -4}}, at(Rational(1, 2)), 9);
  // Over the side by (3 - 3 t, 3): 9 (1 - t)^2 + 9 = 16; nearest 3^2
  worked({{{{1, 3, 3}, {1, 9, 3}}, 1}, bar(3), {0, -3, 0}}, at(Surd(Rational(1), Rational(-1, 3), 7)), 7);
}

TEST_CASE("swept_capsule_capsule: touching is a hit: grazing, sliding, at the start and at the end") {
  worked({{{{2, 1, 7}, {2, 1, 17}}, 2}, bar(3), {0, -8, -6}}, at(Rational(1, 2)), 0);  // by (-3, 4)
  worked({across(4, 2), bar(2), {12, 0, 0}}, at(Rational(0)), 0);                      // slides along it and off
  worked({{{{-10, 1, 4}, {-10, 2, 4}}, 2}, {{{-4, -9, 0}, {-4, 9, 0}}, 2}, {8, 0, 0}}, at(Rational(3, 4)), 0);
  worked({across(6, 1), bar(1), {0, 0, -4}}, at(Rational(1)), 0);
  worked({across(2, 1), bar(1), {0, 0, 1}}, at(Rational(0)), 0);   // they part
  worked({across(2, 1), bar(1), {0, 0, -1}}, at(Rational(0)), 3);  // deeper: 4 - 1
}

TEST_CASE("swept_capsule_capsule: balls, and segments") {
  worked({ball({0, 0, 6}, 1), ball({0, 0, 0}, 1), {0, 0, -8}}, at(Rational(1, 2)), 4);
  worked({ball({1, 8, 0}, 3), bar(0), {0, -10, 0}}, at(Rational(1, 2)), 9);
  worked({across(6, 0), bar(-0.0), {0, 0, -8}}, at(Rational(3, 4)), 4);               // through it, by 2
  worked({{{{-9, 0, 0}, {-6, 0, 0}}, 0}, bar(0), {4, 0, 0}}, at(Rational(1, 2)), 0);  // along its line
  worked({{{{-9, 0, 0}, {-6, 0, 0}}, 0}, bar(0), {1, 0, 0}}, misses, 1);
}

TEST_CASE("swept_capsule_capsule: rounding, huge and subnormal") {
  // The sum of the radii is 2^53 + 1, and so is the distance; 2^53 + 3, which is nearer to 2^53 + 4 than it is
  worked({ball({0x1p53, 0, 0}, 0x1p53), {{{-1, -1, 0}, {-1, 1, 0}}, 1}, {0, 0, 1}}, at(Rational(0)), 0);
  worked({ball({0x1p53, 0, 0}, 0x1p53), {{{-4, -1, 0}, {-4, 1, 0}}, 3}, {0, 0, 0}}, misses, exact(0x1p54) + 7,
         "rounding");
  worked({ball({0, 0, 3 * tiny}, tiny), ball({0, 0, 0}, 0), {0, 0, -4 * tiny}}, at(Rational(1, 2)),
         Rational(exact(tiny) * exact(tiny)), "rounding");
  worked({ball({0, 0, huge}, huge), ball({0, 0, -huge}, huge), {0, 0, 0}}, at(Rational(0)), 0, "rounding");
}

TEST_CASE("swept_capsule_capsule: numbers are refused first, then the radii in order") {
  refused<Row>({bar(-1), bar(1), {0, infinity, 0}}, "velocity[1]", "finite number");
  refused<Row>({bar(-1), {{{0, 0, 0}, {0, 0, not_a_number}}, 1}, {0, 0, 0}}, "b.segment[1][2]", "finite number");
  refused<Row>({bar(-1), bar(-1), {0, 0, 0}}, "a.radius", "radius >= 0");
  refused<Row>({bar(1), bar(-1), {0, 0, 0}}, "b.radius", "radius >= 0");
}

TEST_CASE("swept_capsule_capsule: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::swept_capsule_capsule_tests
