// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/sphere_obb.h"

#include "proptests/box_laws.h"
#include "proptests/round_laws.h"
#include "robust/volumes/point_in_obb.h"
#include "robust/volumes/sphere_aabb.h"

namespace touchstone::proptests::sphere_obb_tests {

using Row = rows::sphere_obb;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;
using namespace worked_boxes;

constexpr Worked<Row> worked;

ROUND_LAWS("sphere_obb")

ROBUST_LAW("sphere_obb: a point only touches the box that it is in, and a ball around one overlaps it", ball, box) {
  return center_tells(ask, ball, box, robust::point_in_obb(box, ball.center));
}

ROBUST_LAW("sphere_obb: a box along the axes has the contact of sphere_aabb", ball, box) {
  const auto straight = straightened(box);
  if (!on_lattice(asked) || !straight) return true;
  return ask(Row::Question{ball, straight->obb}) == robust::sphere_aabb(ball, straight->aabb);
}

TEST_CASE("sphere_obb: balls beside a cube and a turned box, worked by hand") {
  balls_beside(cube, worked);
  worked({{{6, 8, 0}, 5}, turned}, touching, 0);    // beyond a face by (3, 4)
  worked({{{6, 8, 0}, 4}, turned}, disjoint, 9);
  worked({{{-8, 6, 13}, 13}, turned}, touching, 0);  // beyond an edge by (-4, 3) and 12
}

TEST_CASE(
    "sphere_obb: where half axes are not at right angles another point may be nearer than the one that it takes") {
  worked({{{6, 3, 0}, 1}, sheared}, touching, 0, "algorithm");  // over its top, from (4, 2) to (8, 2); takes (8, 2)
  // x - 3 y = -6 is 4 from its side, a square of 16 / 10; it takes (0.6, 0.2), of 3.6.
  worked({{{0, 2, 0}, 1.5}, sheared}, overlapping, Rational(13, 20), "algorithm");
  worked({{{0, 2, 0}, 1}, sheared}, disjoint, Rational(3, 5));
}

TEST_CASE("sphere_obb: points, huge, subnormal and negative zero") {
  worked({{{2, 2, 2}, 0}, cube}, touching, 0);  // its corner
  worked({{{1, 0, 0}, -0.0}, cube}, touching, 0);
  worked({{{3, 2, 2}, 0}, cube}, disjoint, 1);
  const Rational square = exact(tiny) * exact(tiny);
  worked({{{2 * tiny, -0.0, 0}, tiny}, least}, touching, 0);
  worked({{{3 * tiny, 0, 0}, tiny}, least}, disjoint, Rational(3 * square), "rounding");  // 4 - 1
  worked({{{-huge, 0, 0}, huge}, {{huge, 0, 0}, cube.half_axes}}, disjoint,
         Rational((2 * exact(huge) - 2) * (2 * exact(huge) - 2) - exact(huge) * exact(huge)), "rounding");
}

TEST_CASE("sphere_obb: numbers are refused first, then the radius, then the half axes") {
  const Obb3d flat{{0, 0, 0}, {{1, 1, 0}, {0, 1, 1}, {1, 2, 1}}};
  refused<Row>({{{0, 0, 0}, -1}, cube}, "sphere.radius", "radius >= 0");
  refused<Row>({{{0, 0, 0}, -1}, flat}, "sphere.radius", "radius >= 0");
  refused<Row>({{{0, 0, 0}, 1}, flat}, "obb.half_axes", "linearly independent");
  refused<Row>({{{0, 0, 0}, -1}, {{infinity, 0, 0}, flat.half_axes}}, "obb.center[0]", "finite number");
}

CONTRACT("sphere_obb: the formula in double is that in exact arithmetic where the bound of its contract says so", ball,
         box) {
  const ObbBound bound(ball.center, box);
  if (!bound.defined) return true;
  const Vector3<Rational> beyond = exact_point(ball.center) - bound.exactly;
  const Rational s(dot(beyond, beyond)), r(exact(ball.radius) * exact(ball.radius));
  if (!finite(catalogue::nearest(4 * s), catalogue::nearest(4 * r))) return true;
  if (abs(s - r) <= of_square(s, bound.sum) + unit() * r + power_of_two(-1071)) return true;
  return answer == (s > r ? disjoint : overlapping) && (answer == truth.answer || !has_right_angles(box));
}

}  // namespace touchstone::proptests::sphere_obb_tests
