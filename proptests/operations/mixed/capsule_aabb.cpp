// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/capsule_aabb.h"

#include "proptests/round_laws.h"
#include "robust/mixed/capsule_obb.h"

namespace touchstone::proptests::capsule_aabb_tests {

using Row = rows::capsule_aabb;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;
constexpr Aabb3d cube{{-2, -2, -2}, {2, 2, 2}}, flat{{-2, -2, 0}, {2, 2, 0}}, point{{1, 1, 1}, {1, 1, 1}};

constexpr Worked<Row> worked;

ROUND_LAWS("capsule_aabb")

ROBUST_LAW("capsule_aabb: twice as large it has the contact of capsule_obb, unless it is flat", capsule, aabb) {
  const auto& [low, high] = aabb;
  if (!on_lattice(asked) || low.x == high.x || low.y == high.y || low.z == high.z) return true;
  const auto doubled = [](const Point3d& p) { return Point3d{2 * p.x, 2 * p.y, 2 * p.z}; };
  const Vector3d size = high - low;
  const Capsule3d larger{{doubled(capsule.segment.a), doubled(capsule.segment.b)}, 2 * capsule.radius};
  const Obb3d box{low + (high - Point3d{0, 0, 0}), {{size.x, 0, 0}, {0, size.y, 0}, {0, 0, size.z}}};
  return ask(asked) == robust::capsule_obb(larger, box);
}

TEST_CASE("capsule_aabb: capsules beside a cube, worked by hand") {
  worked({{{{-9, 7, 0}, {9, 7, 0}}, 4}, cube}, disjoint, 9);  // along a face: 25 - 16
  worked({{{{-9, 7, 0}, {9, 7, 0}}, 5}, cube}, touching, 0);
  worked({{{{-9, 7, 0}, {9, 7, 0}}, 6}, cube}, overlapping, 11);
  worked({{{{5, 6, 0}, {9, 9, 7}}, 5}, cube}, touching, 0);        // an end beyond an edge by (3, 4)
  worked({{{{10, 2, 5}, {2, 10, -5}}, 6}, cube}, overlapping, 4);  // across an edge by (4, 4): 36 - 32
  worked({{{{-9, 0, 0}, {9, 1, 1}}, 1}, cube}, overlapping, 1);    // through the box
  worked({{{{0, 0, 0}, {1, 1, 1}}, 9}, cube}, overlapping, 16);    // within: a box of width 4
}

TEST_CASE("capsule_aabb: segments, points, flat boxes, huge, subnormal and negative zero") {
  worked({{{{-9, 0, 0}, {9, 1, 1}}, 0}, cube}, touching, 0);
  worked({{{{3, 1, 2}, {1, 3, 2}}, -0.0}, cube}, touching, 0);  // through an edge's point (2, 2, 2)
  worked({{{{1, 1, -3}, {1, 1, 3}}, 0}, flat}, touching, 0);
  worked({{{{1, 1, -3}, {1, 1, 3}}, 1}, flat}, touching, 0, "algorithm");
  worked({{{{3, 3, -3}, {3, 3, 3}}, 1}, flat}, disjoint, 1);
  worked({{{{0, 0, 0}, {3, 3, 3}}, 0}, point}, touching, 0);
  worked({{{{0, 0, 0}, {3, 3, 0}}, 1}, point}, touching, 0);
  worked({{{{2, 2, 2}, {2, 2, 2}}, 0}, point}, disjoint, 3);
  worked({{{{2 * tiny, -0.0, 0}, {9, 0, 0}}, tiny}, {{-1, -1, -1}, {tiny, 1, 1}}}, touching, 0);
  worked({{{{3 * tiny, 0, 0}, {9, 0, 0}}, tiny}, {{-1, -1, -1}, {tiny, 1, 1}}}, disjoint,
         Rational(3 * exact(tiny) * exact(tiny)), "rounding");  // 4 - 1
  worked({{{{-huge, 0, 0}, {-huge, 1, 0}}, huge}, {{1, 0, 0}, {2, 1, 1}}}, disjoint, Rational(2 * exact(huge) + 1),
         "rounding");  // (h + 1)^2 - h^2
}

TEST_CASE("capsule_aabb: numbers are refused first, then the radius, then the box") {
  const Aabb3d inverted{{0, 0, 0}, {1, -1, 1}};
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, -1}, inverted}, "capsule.radius", "radius >= 0");
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, 1}, inverted}, "aabb.max[1]", "min <= max");
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, -1}, {{infinity, 0, 0}, {1, 1, 1}}}, "aabb.min[0]", "finite number");
}

CONTRACT("capsule_aabb: where the formula in double is certain by its contract it answers disjoint", capsule, aabb) {
  const double r = capsule.radius;
  const Point3d x = reference::nearest_to_aabb(capsule.segment, aabb);
  const Vector3d beyond = x - reference::closest_point_on_aabb(x, aabb);
  if (truth.answer != disjoint || !finite(dot(beyond, beyond), r * r)) return true;
  return is_apart_where_certain(truth, answer, std::tuple{capsule.segment}, 3, r);
}

}  // namespace touchstone::proptests::capsule_aabb_tests
