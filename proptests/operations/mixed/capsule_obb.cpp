// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/capsule_obb.h"

#include "proptests/round_laws.h"

namespace touchstone::proptests::capsule_obb_tests {

using Row = rows::capsule_obb;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;
using namespace worked_boxes;

constexpr Worked<Row> worked;

ROUND_LAWS("capsule_obb")

TEST_CASE("capsule_obb: capsules beside a cube and a turned box, worked by hand") {
  worked({{{{-9, 7, 0}, {9, 7, 0}}, 4}, cube}, disjoint, 9);  // along a face: 25 - 16
  worked({{{{-9, 7, 0}, {9, 7, 0}}, 5}, cube}, touching, 0);
  worked({{{{-9, 7, 0}, {9, 7, 0}}, 6}, cube}, overlapping, 11);
  worked({{{{5, 6, 0}, {9, 9, 7}}, 5}, cube}, touching, 0);        // an end beyond an edge by (3, 4)
  worked({{{{10, 2, 5}, {2, 10, -5}}, 6}, cube}, overlapping, 4);  // across an edge by (4, 4): 36 - 32
  worked({{{{-9, 0, 0}, {9, 1, 1}}, 1}, cube}, overlapping, 1);    // through the box
  worked({{{{0, 0, 0}, {1, 1, 1}}, 9}, cube}, overlapping, 81);    // within
  worked({{{{18, -1, 0}, {-6, 17, 0}}, 5}, turned}, touching, 0);  // along a face, beyond it by (3, 4)
  worked({{{{18, -1, 0}, {-6, 17, 0}}, 4}, turned}, disjoint, 9);
  worked({{{{6, 3, 0}, {6, 9, 0}}, 1}, sheared}, touching, 0, "algorithm");  // over its top; takes (8, 2)
}

TEST_CASE("capsule_obb: segments, points, huge, subnormal and negative zero") {
  worked({{{{-9, 0, 0}, {9, 1, 1}}, 0}, cube}, touching, 0);
  worked({{{{3, 1, 2}, {1, 3, 2}}, -0.0}, cube}, touching, 0);  // through an edge's point (2, 2, 2)
  worked({{{{3, 2, 2}, {3, 2, 2}}, 0}, cube}, disjoint, 1);
  const Rational square = exact(tiny) * exact(tiny);
  worked({{{{2 * tiny, -0.0, 0}, {9, 0, 0}}, tiny}, least}, touching, 0);
  worked({{{{3 * tiny, 0, 0}, {9, 0, 0}}, tiny}, least}, disjoint, Rational(3 * square), "rounding");  // 4 - 1
  worked({{{{-huge, 0, 0}, {-huge, 1, 0}}, huge}, {{huge, 0, 0}, cube.half_axes}}, disjoint,
         Rational((2 * exact(huge) - 2) * (2 * exact(huge) - 2) - exact(huge) * exact(huge)), "rounding");
}

TEST_CASE("capsule_obb: numbers are refused first, then the radius, then the half axes") {
  const Obb3d flat{{0, 0, 0}, {{1, 1, 0}, {0, 1, 1}, {1, 2, 1}}};
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, -1}, flat}, "capsule.radius", "radius >= 0");
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, 1}, flat}, "obb.half_axes", "linearly independent");
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, -1}, {{infinity, 0, 0}, flat.half_axes}}, "obb.center[0]", "finite number");
}

CONTRACT("capsule_obb: where the formula in double is certain by its contract it answers disjoint", capsule, obb) {
  const double r = capsule.radius;
  const Point3d x = reference::nearest_to_obb(capsule.segment, obb);
  const Vector3d beyond = x - reference::nearest_in_obb(x, obb);
  if (truth.answer != disjoint || !finite(dot(beyond, beyond), r * r)) return true;
  return is_apart_where_certain(truth, answer, Row::Question{{capsule.segment, 0}, obb}, 9, r);
}

}  // namespace touchstone::proptests::capsule_obb_tests
