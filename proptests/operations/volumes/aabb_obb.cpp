// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/volumes/aabb_obb.h"

#include "proptests/box_laws.h"
#include "proptests/laws.h"
#include "robust/volumes/aabb_aabb.h"
#include "robust/volumes/obb_obb.h"
#include "robust/volumes/sphere_aabb.h"

namespace touchstone::proptests::aabb_obb_tests {
namespace {

using Row = rows::aabb_obb;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;
constexpr Aabb3d cube{{-2, -2, -2}, {2, 2, 2}};

/// Turned by the triple 3, 4, 5 about the z axis.
Obb3d turned(double x, double y = 0) { return {{x, y, 0}, {{3, 4, 0}, {-4, 3, 0}, {0, 0, 1}}}; }
bool flat(const Aabb3d& b) { return b.min.x == b.max.x || b.min.y == b.max.y || b.min.z == b.max.z; }

constexpr Worked<Row> worked;

}  // namespace

LAW("aabb_obb: half axes may be exchanged and reversed", aabb, obb) {
  return ask(in_another_order<1>(asked)) == ask(asked);
}

LAW("aabb_obb: a box that grows never loses contact, and no flat one overlaps", aabb, obb) {
  Aabb3d larger = aabb;
  larger.min.x = -greatest, larger.max.z = greatest;
  const Contact contact = ask(asked);
  return ask(Row::Question{larger, obb}) >= contact && !(flat(aabb) && contact == overlapping);
}

ROBUST_LAW("aabb_obb: a box of even width has the contact of obb_obb", aabb, obb) {
  const Vector3d half = 0.5 * (aabb.max - aabb.min);
  const auto whole = [](double x) { return x == std::trunc(x); };
  if (!on_lattice(asked) || flat(aabb) || !whole(half.x) || !whole(half.y) || !whole(half.z)) return true;
  const Obb3d straight{aabb.min + half, {{0, half.y, 0}, {half.x, 0, 0}, {0, 0, half.z}}};
  return ask(asked) == robust::obb_obb(straight, obb) && ask(asked) == robust::obb_obb(obb, straight);
}

ROBUST_LAW("aabb_obb: boxes along the axes have the contact of aabb_aabb", aabb, obb) {
  const auto straight = straightened(obb);
  if (!on_lattice(asked) || !straight) return true;
  return ask(Row::Question{aabb, straight->obb}) == robust::aabb_aabb(aabb, straight->aabb);
}

ROBUST_LAW("aabb_obb: a corner of the oriented box in the other means that they meet", aabb, obb) {
  if (!on_lattice(asked)) return true;
  for (const Point3d& corner : corners(obb))
    if (ask(asked) < robust::sphere_aabb(Sphere3d{corner, 0}, aabb)) return false;
  return true;
}

TEST_CASE("aabb_obb: a turned box beside a cube, worked by hand") {
  worked({cube, turned(10)}, disjoint, 1);  // along x: 10; 2 + 7
  worked({cube, turned(9, 0.5)}, touching, 0);
  worked({cube, turned(8.5, 0.5)}, overlapping, Rational(1, 4), "algorithm");  // edges along z are parallel
  // On 3 x + 4 y: 14 of the cube, 25 of the turned box; |3 * 6 + 4 * 6| = 42 is 3 more.
  worked({cube, turned(6, 6)}, disjoint, Rational(9, 25));
  // Of 1 by 2 by 4 within the other: its least width may become 0.
  worked({{{0, 0, -2}, {1, 2, 2}}, {{1, 0, 1}, {{40, 1, 0}, {0, 50, 1}, {1, 0, 60}}}}, overlapping, 1);
}

TEST_CASE("aabb_obb: a flat box only touches, and on its side the textbook test has no axis") {
  // A box on its corner, 5 lower than its center.
  const auto on_corner = [](double y) { return Obb3d{{0, y, 0}, {{1, 2, 2}, {2, 1, -2}, {2, -2, 1}}}; };
  const Aabb3d square{{-10, 0, -10}, {10, 0, 10}};
  worked({square, on_corner(6)}, disjoint, 1, "algorithm");
  worked({square, on_corner(5)}, touching, 0);
  worked({square, on_corner(1)}, touching, 0);
  worked({{{0, 0, 0}, {0, 0, 0}}, on_corner(0)}, touching, 0);     // a point inside
  worked({{{0, 0, 0}, {0, 0, -0.0}}, on_corner(9)}, disjoint, 9);  // 2 * 9 - 9 of length 3
}

TEST_CASE("aabb_obb: rounding, huge and subnormal") {
  const HalfAxes<double> straight{{2, 0, 0}, {0, 2, 0}, {0, 0, 2}};
  // The width has 54 digits: its half ends at 2^53 - 1.
  worked({{{-1, -2, -2}, {0x1p53, 2, 2}}, {{0x1p53 + 2, 0, 0}, straight}}, touching, 0, "rounding");
  worked({{{huge, -1, -1}, {1.5 * huge, 1, 1}}, {{0, 0, 0}, {{huge, 0, 0}, {0, 2, 0}, {0, 0, 3}}}}, touching, 0);
  worked({{{-tiny, -1, -1}, {0, 1, 1}}, {{2 * tiny, 0, 0}, {{tiny, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, disjoint,
         Rational(exact(tiny) * exact(tiny)));
}

TEST_CASE("aabb_obb: numbers are refused first, then min and max, then the half axes") {
  const Obb3d in_a_plane{{0, 0, 0}, {{1, 1, 0}, {0, 1, 1}, {1, 2, 1}}};
  const Aabb3d reversed{{0, 0, 1}, {1, 1, 0}};
  refused<Row>({reversed, {{0, infinity, 0}, in_a_plane.half_axes}}, "obb.center[1]", "finite number");
  refused<Row>({reversed, in_a_plane}, "aabb.max[2]", "min <= max");
  refused<Row>({cube, in_a_plane}, "obb.half_axes", "linearly independent");
}

CONTRACT("aabb_obb: the formula answers as obb_obb's of a box whose faces are no farther off than its contract says",
         aabb, obb) {
  const Obb3d box = reference::as_obb(aabb);
  const auto& [u, v, w] = box.half_axes;
  const auto keeps = [](double center, double half, double min, double max) {
    if (!finite(center, half)) return true;
    const Rational bound = 3 * unit() * (size(min) + size(max)) + power_of_two(-1074);
    return abs(exact(center) - exact(half) - exact(min)) <= bound &&
           abs(exact(center) + exact(half) - exact(max)) <= bound;
  };
  return keeps(box.center.x, u.x, aabb.min.x, aabb.max.x) && keeps(box.center.y, v.y, aabb.min.y, aabb.max.y) &&
         keeps(box.center.z, w.z, aabb.min.z, aabb.max.z) && answer == reference::obb_obb(box, obb);
}

}  // namespace touchstone::proptests::aabb_obb_tests
