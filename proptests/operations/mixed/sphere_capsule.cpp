// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/sphere_capsule.h"

#include "proptests/round_laws.h"

namespace touchstone::proptests::sphere_capsule_tests {
namespace {

using Row = rows::sphere_capsule;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

/// Along x from 0 to 10.
Capsule3d along_x(double radius) { return {{{0, 0, 0}, {10, 0, 0}}, radius}; }

constexpr Worked<Row> worked;

}  // namespace

ROUND_LAWS("sphere_capsule")

TEST_CASE("sphere_capsule: beside it and beyond its ends, worked by hand") {
  worked({{{3, 6, 0}, 2}, along_x(3)}, disjoint, 11);  // 6^2 - 5^2
  worked({{{3, 5, 0}, 2}, along_x(3)}, touching, 0);
  worked({{{3, 4, 0}, 2}, along_x(3)}, overlapping, 9);
  worked({{{13, 4, 0}, 2}, along_x(3)}, touching, 0);    // beyond b by 3, 4, 5
  worked({{{-3, 0, 4}, 1}, along_x(3)}, disjoint, 9);    // beyond a
  worked({{{3, 0, 0}, 1}, along_x(3)}, overlapping, 7);  // within: 4^2 - 3^2, should the ball become a point
}

TEST_CASE("sphere_capsule: a radius of 0, and a segment of length 0") {
  worked({{{3, 1, 0}, 0}, along_x(3)}, touching, 0, "algorithm");  // 1 < 9
  worked({{{3, 1, 0}, 3}, along_x(-0.0)}, touching, 0, "algorithm");
  worked({{{3, 3, 0}, 0}, along_x(3)}, touching, 0);
  worked({{{3, 4, 0}, 0}, along_x(3)}, disjoint, 7);
  worked({{{3, 0, 0}, 0}, along_x(0)}, touching, 0);
  worked({{{3, 4, 0}, 3}, {{{0, 0, 0}, {0, -0.0, 0}}, 2}}, touching, 0);  // 0 / 0 happens to say so
  worked({{{3, 4, 0}, 2}, {{{0, 0, 0}, {0, -0.0, 0}}, 2}}, disjoint, 9, "algorithm");
}

TEST_CASE("sphere_capsule: rounding, huge and subnormal") {
  worked({{{-0x1p27, 1, 0}, 0x1p27}, along_x(0)}, disjoint, 1, "rounding");
  worked({{{-0x1p53, 0, 0}, 0x1p53 - 1}, along_x(1)}, touching, 0);
  worked({{{-huge, 0, 0}, huge}, along_x(1)}, overlapping, Rational(2 * exact(huge) + 1),
         "rounding");  // (h + 1)^2 - h^2
  worked({{{5, tiny, 0}, 0}, along_x(0)}, disjoint, Rational(exact(tiny) * exact(tiny)), "rounding");
  worked({{{5, 2 * tiny, 0}, tiny}, along_x(tiny)}, touching, 0);
}

CONTRACT("sphere_capsule: the formula in double keeps its contract", ball, capsule) {
  const auto& [a, b] = capsule.segment;
  const Point3d x = reference::nearest_between<double>(ball.center, a, b);
  const SegmentBound bound(ball.center, a, b, x);
  const double sum = ball.radius + capsule.radius;
  if (!bound.defined || !finite(sum * sum)) return true;
  const std::vector<Rational> p = exact_coordinates(ball.center);
  Rational square;
  for (std::size_t k = 0; k < 3; ++k) square += (p[k] - bound.exactly[k]) * (p[k] - bound.exactly[k]);
  const Rational u = unit(), r(exact(ball.radius) + exact(capsule.radius)), reach(r * r);
  const Rational room(of_square(square, bound.sum) + (3 + 4 * u) * u * reach + power_of_two(-1072));
  if (abs(square - reach) <= room) return true;
  const Contact inside = ball.radius == 0 || capsule.radius == 0 ? touching : overlapping;
  return answer == (square > reach ? disjoint : overlapping) && truth.answer == (square > reach ? disjoint : inside);
}

}  // namespace touchstone::proptests::sphere_capsule_tests
