// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/sphere_plane.h"

#include "proptests/half_space_laws.h"
#include "robust/planes/point_plane.h"
#include "robust/sweeps/swept_sphere_plane.h"

namespace touchstone::proptests::sphere_plane_tests {
namespace {

using Row = rows::sphere_plane;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

Row::Question over_ground(double height, double radius) { return {{{3, height, -1}, radius}, ground}; }

bool is_point(const Sphere3d& ball) { return ball.radius == 0; }

constexpr Worked<Row> worked;

}  // namespace

HALF_SPACE_LAWS("sphere_plane", is_point)

LAW("sphere_plane: a ball that grows never loses contact, and one that touched overlaps", sphere, plane) {
  if (sphere.radius == greatest) return true;
  const Contact then = ask(Row::Question{{sphere.center, catalogue::moved_by_ulps(sphere.radius, 1)}, plane});
  return ask(asked) == disjoint || then == overlapping;
}

ROBUST_LAW("sphere_plane: a ball meets the half-space exactly if it meets the plane or its center is on the back",
           sphere, plane) {
  const bool meets_plane = robust::swept_sphere_plane(sphere, {0, 0, 0}, plane).relation == HitRelation::hit;
  const PlaneSide side = robust::point_plane_side(plane, sphere.center);
  const Contact contact = ask(asked), of_center = ask(Row::Question{{sphere.center, 0}, plane});
  return (contact != disjoint) == (meets_plane || side == PlaneSide::back) &&
         of_center == (side == PlaneSide::front ? disjoint : touching);
}

TEST_CASE("sphere_plane: heights and radii worked by hand") {
  worked(over_ground(5, 2), disjoint, 21);     // 5^2 - 2^2
  worked(over_ground(2, 2), touching, 0);      // it reaches the ground from above
  worked(over_ground(1, 2), overlapping, 3);   // 2^2 - 1^2
  worked(over_ground(0, 2), overlapping, 4);   // half of it is behind
  worked(over_ground(-2, 2), overlapping, 4);  // touches the plane from behind: its radius may become 0
  worked(over_ground(-9, 2), overlapping, 4);  // within the half-space
  // E = 3 + 12 + 12 - 9 = 18 of length 3 |N|: 6 away.
  worked({{{3, 6, 6}, 6}, {{1, 2, 2}, -9}}, touching, 0);
  worked({{{3, 6, 6}, 6}, {{-1, -2, -2}, 9}}, overlapping, 36);  // its other side
  // E = 3, |N| = sqrt(2): 9 / 2 against r^2.
  worked({{{3, 0, 0}, 2}, {{1, 1, 0}, 0}}, disjoint, Rational(1, 2));
  worked({{{3, 0, 0}, 3}, {{1, 1, 0}, 0}}, overlapping, Rational(9, 2));
}

TEST_CASE("sphere_plane: a point in the half-space only touches it; the formula sees an overlap behind the plane") {
  worked(over_ground(3, 0), disjoint, 9);
  worked(over_ground(0, 0), touching, 0);
  worked(over_ground(-3, 0), touching, 0, "algorithm");  // -3 < 0
  worked(over_ground(-tiny, -0.0), touching, 0, "algorithm");
}

TEST_CASE("sphere_plane: rounding, huge, subnormal and negative zero") {
  const Rational least = exact(tiny) * exact(tiny);
  // 1 + 2^-60 high, radius 1.
  worked({{{1, 0, 0}, 1}, {{1, 0, 0}, 0x1p-60}}, disjoint, Rational(power_of_two(-59) + power_of_two(-120)),
         "rounding");
  worked(over_ground(2 * tiny, tiny), disjoint, Rational(3 * least));
  worked(over_ground(-3, tiny), overlapping, least);
  worked(over_ground(huge, huge), touching, 0);
  worked({{{0, 3, 0}, 3}, {{0, tiny, 0}, 0}}, touching, 0, "rounding");  // |N| is 0
  worked({{{0, 1, 0}, 1}, {{0, huge, 0}, 0}}, touching, 0, "rounding");  // and infinite
  worked({{{-0.0, -0.0, 0}, -0.0}, {{-0.0, 1, 0}, -0.0}}, touching, 0);
}

CONTRACT("sphere_plane: the formula in double keeps its contract", sphere, plane) {
  return keeps_contract_over_plane({sphere.center}, sphere.radius, plane, answer, truth.answer);
}

}  // namespace touchstone::proptests::sphere_plane_tests
