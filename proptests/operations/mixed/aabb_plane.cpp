// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/aabb_plane.h"

#include "proptests/half_space_laws.h"
#include "robust/mixed/sphere_plane.h"
#include "robust/planes/point_plane.h"

namespace touchstone::proptests::aabb_plane_tests {
namespace {

using Row = rows::aabb_plane;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

/// 2 wide, 2 high, 2 deep, its bottom at that height.
Row::Question over_ground(double height) { return {{{3, height, -1}, {5, height + 2, 1}}, ground}; }

bool flat(const Aabb3d& b) { return b.min.x == b.max.x || b.min.y == b.max.y || b.min.z == b.max.z; }

std::vector<Point3d> corners(const Aabb3d& box) {
  std::vector<Point3d> all;
  for (const double x : {box.min.x, box.max.x})
    for (const double y : {box.min.y, box.max.y})
      for (const double z : {box.min.z, box.max.z}) all.push_back({x, y, z});
  return all;
}

constexpr Worked<Row> worked;

}  // namespace

HALF_SPACE_LAWS("aabb_plane", flat)

ROBUST_LAW("aabb_plane: the contact follows from the sides of the eight corners", box, plane) {
  int front = 0, behind = 0;
  for (const Point3d& corner : corners(box)) {
    const PlaneSide side = robust::point_plane_side(plane, corner);
    front += static_cast<int>(side == PlaneSide::front), behind += static_cast<int>(side == PlaneSide::back);
  }
  return ask(asked) == (front == 8 ? disjoint : behind == 0 || flat(box) ? touching : overlapping);
}

LAW("aabb_plane: a box that grows never loses contact", box, plane) {
  Aabb3d larger = box;
  larger.min.x = -greatest, larger.max.z = greatest;
  return ask(Row::Question{larger, plane}) >= ask(asked);
}

ROBUST_LAW("aabb_plane: a box of one point has the contact of a ball of radius 0", box, plane) {
  return ask(Row::Question{{box.max, box.max}, plane}) == robust::sphere_plane({box.max, 0}, plane);
}

TEST_CASE("aabb_plane: heights worked by hand") {
  worked(over_ground(5), disjoint, 25);
  worked(over_ground(0), touching, 0);      // a face on the ground
  worked(over_ground(-1), overlapping, 1);  // half of it is behind
  worked(over_ground(-9), overlapping, 4);  // within the half-space: its width of 2 may become 0
  // x + y + z = 3: the corner (1, 1, 1) is on it; E = 1 and -2, of which 1/3 and 4/3 are squares of distances.
  worked({{{1, 1, 1}, {4, 4, 4}}, {{1, 1, 1}, -3}}, touching, 0);
  worked({{{1, 1, 2}, {4, 4, 4}}, {{1, 1, 1}, -3}}, disjoint, Rational(1, 3));
  worked({{{1, 0, 0}, {4, 4, 4}}, {{1, 1, 1}, -3}}, overlapping, Rational(4, 3));
  // Every slope of the normal falls: the greatest corner is the lowest.
  worked({{{-4, -4, -4}, {-1, -1, -1}}, {{-1, -1, -1}, -3}}, touching, 0);
  worked({{{-4, 1, -4}, {-1, 4, -1}}, {{-1, 1, -1}, -3}}, touching, 0);
  // An edge on the plane x = z.
  worked({{{2, 0, 0}, {3, 1, 2}}, {{1, 0, -1}, 0}}, touching, 0);
}

TEST_CASE("aabb_plane: a flat box only touches; the formula sees an overlap behind the plane") {
  worked({{{0, -1, 0}, {1, -1, 1}}, ground}, touching, 0, "algorithm");  // a rectangle behind the plane
  worked({{{0, -1, 0}, {0, 1, 1}}, ground}, touching, 0, "algorithm");   // one through it
  worked({{{0, 0, 0}, {1, 0, 1}}, ground}, touching, 0);                 // in it
  worked({{{0, -3, 0}, {0, -3, 0}}, ground}, touching, 0, "algorithm");  // a point
  worked({{{0, 2, 0}, {0, 2, 0}}, ground}, disjoint, 4);                 // another
  worked({{{0, -tiny, 0}, {1, -0.0, 1}}, ground}, overlapping, Rational(exact(tiny) * exact(tiny)));
}

TEST_CASE("aabb_plane: rounding, huge, subnormal and negative zero") {
  // 2^53 + 1 high, of which the last bit is lost: E is 0.
  worked({{{0x1p53, 1, 0}, {0x1p54, 2, 1}}, {{1, 1, 0}, -0x1p53}}, disjoint, Rational(1, 2), "rounding");
  worked({{{huge, 0, 0}, {greatest, 1, 1}}, {{huge, 0, 0}, -huge}}, disjoint,
         Rational((exact(huge) - 1) * (exact(huge) - 1)));
  worked({{{huge, 0, 0}, {greatest, 1, 1}}, {{-huge, 0, 0}, 1}}, overlapping, 1);
  worked({{{0, 0, 0}, {1, 1, 1}}, {{-tiny, 0, 0}, tiny}}, touching, 0);
  worked({{{tiny, 0, 0}, {1, 1, 1}}, {{tiny, 0, 0}, 0}}, disjoint, Rational(exact(tiny) * exact(tiny)), "rounding");
  worked({{{-0.0, 0.0, -0.0}, {1, 1, 1}}, {{1, -0.0, 0}, -0.0}}, touching, 0);
}

CONTRACT("aabb_plane: the formula in double keeps its contract", box, plane) {
  const Vector3d& n = plane.normal;
  const HeightBound e(
      plane, {n.x < 0 ? box.max.x : box.min.x, n.y < 0 ? box.max.y : box.min.y, n.z < 0 ? box.max.z : box.min.z});
  if (!e.certain()) return true;
  const Contact expected = e.computed > 0 ? disjoint : overlapping;
  return answer == expected && truth.answer == (expected == overlapping && flat(box) ? touching : expected);
}

}  // namespace touchstone::proptests::aabb_plane_tests
