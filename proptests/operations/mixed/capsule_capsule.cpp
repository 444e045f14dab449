// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/capsule_capsule.h"

#include "oracle/mixed/segment_segment_distance.h"
#include "proptests/round_laws.h"

namespace touchstone::proptests::capsule_capsule_tests {
namespace {

using Row = rows::capsule_capsule;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

/// Along x from 0 to 10.
Capsule3d along_x(double radius) { return {{{0, 0, 0}, {10, 0, 0}}, radius}; }
/// Across it, so high above.
Capsule3d across(double height, double radius) { return {{{3, height, -5}, {3, height, 5}}, radius}; }

constexpr Worked<Row> worked;

}  // namespace

ROUND_LAWS("capsule_capsule")

LAW("capsule_capsule: a capsule overlaps itself, unless its radius is 0", a) {
  return ask(Row::Question{a, a}) == (a.radius == 0 ? touching : overlapping);
}

TEST_CASE("capsule_capsule: across each other, end to end, worked by hand") {
  worked({along_x(2), across(6, 3)}, disjoint, 11);
  worked({along_x(2), across(5, 3)}, touching, 0);
  worked({along_x(2), across(4, 3)}, overlapping, 9);
  worked({along_x(2), across(0, 3)}, overlapping, 16);  // crossing: 5^2 - 3^2, should the first have no radius
  worked({along_x(2), {{{13, 4, 0}, {20, 9, 1}}, 3}}, touching, 0);
  worked({along_x(2), {{{13, 4, 0}, {20, 9, 1}}, 2}}, disjoint, 9);
}

TEST_CASE("capsule_capsule: parallel ones, by which the formula divides by 0") {
  worked({along_x(2), {{{3, 5, 0}, {5, 5, 0}}, 3}}, touching, 0);  // 0 / 0 happens to say so
  worked({along_x(2), {{{3, 5, 0}, {5, 5, 0}}, 2}}, disjoint, 9, "algorithm");
  worked({along_x(2), {{{3, 5, 0}, {5, 5, 0}}, 4}}, overlapping, 11, "algorithm");
  worked({along_x(2), {{{13, 0, 0}, {15, 0, 0}}, 1}}, touching, 0);  // collinear
}

TEST_CASE("capsule_capsule: a radius of 0, and a segment of length 0") {
  worked({along_x(0), across(1, 3)}, touching, 0, "algorithm");
  worked({along_x(3), across(1, -0.0)}, touching, 0, "algorithm");
  worked({along_x(0), across(0, 0)}, touching, 0);
  worked({along_x(0), across(tiny, 0)}, disjoint, Rational(exact(tiny) * exact(tiny)), "rounding");
  worked({along_x(1), {{{3, 4, 0}, {3, 4, 0}}, 2}}, disjoint, 7, "algorithm");
}

TEST_CASE("capsule_capsule: rounding and huge") {
  worked({along_x(0), {{{-0x1p27, 1, 0}, {-0x1p27, 2, 1}}, 0x1p27}}, disjoint, 1, "rounding");
  worked({along_x(1), across(huge, huge)}, overlapping, Rational(2 * exact(huge) + 1), "rounding");  // (h + 1)^2 - h^2
}

CONTRACT("capsule_capsule: where the formula in double is certain by its contract it answers disjoint", a, b) {
  const auto [x, y] = reference::nearest_of_segments<double>(a.segment.a, a.segment.b, b.segment.a, b.segment.b);
  const double sum = a.radius + b.radius;
  if (!finite(dot(x - y, x - y), sum * sum)) return true;
  const Rational u = unit();
  Rational e;
  for (const Segment3d& s : {a.segment, b.segment}) {
    const std::vector<Rational> p = exact_coordinates(s.a), q = exact_coordinates(s.b);
    for (std::size_t k = 0; k < 3; ++k) e += 5 * u * (abs(p[k]) + abs(q[k])) + power_of_two(-1074);
  }
  const Rational r(exact(a.radius) + exact(b.radius));
  const Rational square =
      oracle::segment_segment_distance(a.segment, b.segment).answer.squared_distance.rational_part();
  return !certainly_apart(square, e, r) || (answer == disjoint && truth.answer == disjoint);
}

}  // namespace touchstone::proptests::capsule_capsule_tests
