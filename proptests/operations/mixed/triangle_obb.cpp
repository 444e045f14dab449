// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/triangle_obb.h"

#include "proptests/round_laws.h"
#include "robust/mixed/capsule_obb.h"
#include "robust/mixed/triangle_aabb.h"
#include "robust/polyhedra/segment_triangle.h"

namespace touchstone::proptests::triangle_obb_tests {

using Row = rows::triangle_obb;
using namespace worked_boxes;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

constexpr Worked<Row> worked;

LAW("triangle_obb: the order of corners and half axes does not matter, nor where half axes lead", t, obb) {
  return same_if_rewritten(ask, t, obb);
}

LAW("triangle_obb: a part of a triangle has no more contact than all of it", t, obb) {
  return ask(Row::Question{{t.a, t.b, t.b}, obb}) <= ask(asked) &&
         ask(Row::Question{{t.c, t.c, t.c}, obb}) <= ask(asked);
}

LAW("triangle_obb: a triangle that meets a box overlaps one that is twice as large", t, obb) {
  Obb3d larger = obb;
  for (Vector3d* axis : catalogue::each_of(larger.half_axes)) *axis = 2.0 * *axis;
  for (const double number : numbers_of(std::tuple{larger}))
    if (!finite(number)) return true;
  return ask(asked) == disjoint || ask(Row::Question{t, larger}) == overlapping;
}

ROBUST_LAW("triangle_obb: of a box along the axes it has the contact of triangle_aabb", t, obb) {
  const auto straight = straightened(obb);
  if (!on_lattice(asked) || !straight) return true;
  return ask(Row::Question{t, straight->obb}) == robust::triangle_aabb(t, straight->aabb);
}

ROBUST_LAW("triangle_obb: they meet exactly if a side of one meets the other", t, obb) {
  if (!on_lattice(asked)) return true;
  bool meet = false;
  for (const Segment3d& side : {Segment3d{t.a, t.b}, Segment3d{t.b, t.c}, Segment3d{t.c, t.a}})
    meet = meet || robust::capsule_obb({side, 0}, obb) != disjoint;
  const std::vector<Point3d> ends = corners(obb);
  for (std::size_t i = 0; i < 8; ++i)
    for (const std::size_t bit : {1U, 2U, 4U})
      meet = meet || robust::segment_triangle_relation({ends[i], ends[i ^ bit]}, t) != SegmentTriangleRelation::none;
  return (ask(asked) != disjoint) == meet;
}

TEST_CASE("triangle_obb: a cube, and a turned box, worked by hand") {
  const auto level = [](double y) { return Triangle3d{{-1, y, -1}, {3, y, 0}, {0, y, 3}}; };
  worked({level(3), cube}, disjoint, 1);
  worked({level(2), cube}, touching, 0);  // in the plane of a face
  worked({level(1), cube}, overlapping, 1);
  // In the frame of the box its edge r = 1, s = -1; the triangles lie in planes of constant r - s: 3, 2 and 3 / 2.
  worked({{{10, 5, 0}, {9, 12, 3}, {11, -2, 3}}, turned}, disjoint, Rational(1, 4));
  worked({{{7, 1, 0}, {6, 8, 3}, {8, -6, 3}}, turned}, touching, 0);
  worked({{{5.5, -1, 0}, {4.5, 6, 3}, {6.5, -8, 3}}, turned}, overlapping, Rational(1, 16));
  worked({{{6, 2, 0}, {5, 4, 0.5}, {7, 4, 0.25}}, sheared}, touching, 0, "algorithm");  // on its top
}

TEST_CASE("triangle_obb: a triangle without area is a segment or a point") {
  worked({{{3, 1, 1}, {1, 3, 1}, {3, 1, 1}}, cube}, touching, 0);  // x + y = 4
  worked({{{4, 1, 1}, {1, 4, 1}, {2, 3, 1}}, cube}, disjoint, Rational(1, 4));
  worked({{{3, 0, 1}, {0, 3, 1}, {1, 2, 1}}, cube}, overlapping, Rational(1, 4), "algorithm");
  worked({{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}}, cube}, touching, 0);
  worked({{{1, 1, 0.5}, {1, 1, 0.5}, {1, 1, 0.5}}, cube}, overlapping, 1, "algorithm");
}

TEST_CASE("triangle_obb: huge, subnormal and negative zero") {
  worked({{{-huge, 0, 0}, {-huge, 1, 0}, {-huge, 0, 1}}, {{huge, 0, 0}, cube.half_axes}}, disjoint,
         Rational(4 * (exact(huge) - 1) * (exact(huge) - 1)), "rounding");
  worked({{{2 * tiny, 0, 0}, {2 * tiny, 1, 0}, {2 * tiny, 0, 1}}, least}, disjoint, Rational(exact(tiny) * exact(tiny)),
         "rounding");
  worked({{{2, -0.0, 0}, {9, 1, -0.0}, {9, 0, 1}}, cube}, touching, 0);
}

TEST_CASE("triangle_obb: numbers are refused first, then the half axes") {
  const Obb3d flat{{0, 0, 0}, {{1, 1, 0}, {0, 1, 1}, {1, 2, 1}}};
  refused<Row>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, flat}, "obb.half_axes", "linearly independent");
  refused<Row>({{{0, 0, 0}, {1, infinity, 0}, {0, 1, 0}}, flat}, "triangle[1][1]", "finite number");
  refused<Row>({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, -infinity}, flat.half_axes}}, "obb.center[2]",
               "finite number");
}

CONTRACT("triangle_obb: the formula answers as triangle_aabb's of coordinates as near as its contract says", t, obb) {
  const Rational u = unit();
  const auto keeps = [&](const Point3d& p, const Vector3d& axis, double coordinate) {
    const double length = dot(axis, axis);
    if (!finite(dot(p - obb.center, axis), length, coordinate) || length < 0x1p-960) return true;
    const std::vector<Rational> h = exact_coordinates(axis);
    const ExactProducts products(exact_between(obb.center, p), h);
    const Rational square = ExactProducts(h, h).sum;
    const Rational bound(((8 + 48 * u) * u * products.sizes + power_of_two(-1072)) / square + power_of_two(-1075));
    return within(coordinate, Rational(products.sum / square), bound);
  };
  const auto seen = [&](const Point3d& p) { return reference::in_frame(p, obb); };
  for (const Point3d& p : {t.a, t.b, t.c}) {
    const Point3d x = seen(p);
    const auto& [v, w, n] = obb.half_axes;
    if (!keeps(p, v, x.x) || !keeps(p, w, x.y) || !keeps(p, n, x.z)) return false;
  }
  return answer == reference::triangle_aabb<double>({seen(t.a), seen(t.b), seen(t.c)}, {{-1, -1, -1}, {1, 1, 1}});
}

}  // namespace touchstone::proptests::triangle_obb_tests
