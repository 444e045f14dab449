// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/planes/obb_plane.h"

#include "proptests/box_laws.h"
#include "proptests/half_space_laws.h"
#include "robust/mixed/aabb_plane.h"
#include "robust/planes/point_plane.h"

namespace touchstone::proptests::obb_plane_tests {
namespace {

using Row = rows::obb_plane;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

/// Turned by the triple 3, 4, 5 about the z axis; its center that high.
Row::Question turned_over_ground(double height) {
  return {{{3, height, -1}, {{4, -3, 0}, {3, 4, 0}, {0, 0, 1}}}, ground};
}
bool flat(const Obb3d&) { return false; }

constexpr Worked<Row> worked;

}  // namespace

HALF_SPACE_LAWS("obb_plane", flat)

LAW("obb_plane: half axes may be exchanged and reversed", box, plane) {
  return ask(in_another_order<0>(asked)) == ask(asked);
}

ROBUST_LAW("obb_plane: the contact follows from the sides of the eight corners", box, plane) {
  if (!on_lattice(asked)) return true;
  int front = 0, behind = 0;
  for (const Point3d& corner : corners(box)) {
    const PlaneSide side = robust::point_plane_side(plane, corner);
    front += static_cast<int>(side == PlaneSide::front), behind += static_cast<int>(side == PlaneSide::back);
  }
  return ask(asked) == (front == 8 ? disjoint : behind == 0 ? touching : overlapping);
}

ROBUST_LAW("obb_plane: a box along the axes has the contact of aabb_plane", box, plane) {
  const auto straight = straightened(box);
  if (!on_lattice(asked) || !straight) return true;
  return ask(Row::Question{straight->obb, plane}) == robust::aabb_plane(straight->aabb, plane);
}

TEST_CASE("obb_plane: heights worked by hand") {
  worked(turned_over_ground(9), disjoint, 4);  // its lowest corner is 3 + 4 lower
  worked(turned_over_ground(7), touching, 0);  // on an edge
  worked(turned_over_ground(5), overlapping, 4);
  worked(turned_over_ground(-9), overlapping, 256);  // within the half-space
  // x + y + z = 3 and the cube from 1 to 3 around 2: E of its lowest corner is 0; then 1, of which 1/3 is the square.
  const Obb3d cube{{2, 2, 2}, {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}};
  worked({cube, {{1, 1, 1}, -3}}, touching, 0);
  worked({cube, {{1, 1, 1}, -2}}, disjoint, Rational(1, 3));
  worked({cube, {{-1, -1, -1}, 9}}, touching, 0);  // its highest
  worked({cube, {{-2, 0, 0}, 6}}, touching, 0);    // a face
  // Half axes that are not at right angles: 1 + 5 lower.
  worked({{{0, 6, 0}, {{2, 1, 0}, {2, -5, 0}, {7, 0, 1}}}, ground}, touching, 0);
}

TEST_CASE("obb_plane: rounding, huge, subnormal and negative zero") {
  const Rational square = exact(tiny) * exact(tiny);
  const HalfAxes<double> least{{tiny, 0, 0}, {0, tiny, 0}, {0, 0, tiny}}, unit{{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  worked({{{0, tiny, 0}, least}, ground}, touching, 0);
  worked({{{0, 0, 0}, least}, ground}, overlapping, square);
  worked({{{0, 3 * tiny, 0}, least}, ground}, disjoint, Rational(4 * square));
  // Of 2^53 + 1 the last bit is lost: E is 1, and the sum 2.
  worked({{{0x1p53, 1, 0}, unit}, {{1, 1, 0}, -0x1p53 + 1}}, touching, 0, "rounding");
  worked({{{0x1p53, 2, 0}, unit}, {{1, 1, 0}, -0x1p53 + 1}}, disjoint, Rational(1, 2));
  worked({{{huge, 0, 0}, {{huge, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {{huge, 0, 0}, 0}}, touching, 0);  // inf = inf
  worked({{{-0.0, 1, 0}, {{1, -0.0, 0}, {-0.0, -1, 0}, {0, 0, 1}}}, {{-0.0, 1, 0}, -0.0}}, touching, 0);
}

TEST_CASE("obb_plane: numbers are refused first, then the half axes, then the normal") {
  const Obb3d flat{{0, 0, 0}, {{1, 1, 0}, {0, 1, 1}, {1, 2, 1}}}, box{{0, 0, 0}, {{1, 1, 0}, {0, 1, 1}, {1, 2, 0}}};
  refused<Row>({flat, {{0, not_a_number, 0}, 0}}, "plane.normal[1]", "finite number");
  refused<Row>({flat, {{0, 0, 0}, 0}}, "obb.half_axes", "linearly independent");
  refused<Row>({box, {{0, 0, -0.0}, 1}}, "plane.normal", "nonzero normal");
}

CONTRACT("obb_plane: the formula in double is that in exact arithmetic where the bound of its contract says so", box,
         plane) {
  const Vector3d& n = plane.normal;
  const auto along = [&n](const Vector3d& v) {
    return Rational(exact(n.x) * exact(v.x) + exact(n.y) * exact(v.y) + exact(n.z) * exact(v.z));
  };
  const auto products = [&n](const Vector3d& v) {
    return Rational(size(n.x) * size(v.x) + size(n.y) * size(v.y) + size(n.z) * size(v.z));
  };
  const Vector3d c = box.center - Point3d{0, 0, 0};
  Rational gap = along(c) + exact(plane.offset), sum = products(c) + size(plane.offset);
  for (const Vector3d& axis : {box.half_axes.u, box.half_axes.v, box.half_axes.w})
    gap -= abs(along(axis)), sum += products(axis);
  if (!finite(catalogue::nearest(2 * sum))) return true;
  const Rational u = unit();
  return abs(gap) <= (5 + 11 * u) * u * sum + power_of_two(-1071) || answer == truth.answer;
}

}  // namespace touchstone::proptests::obb_plane_tests
