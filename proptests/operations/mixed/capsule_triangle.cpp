// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/capsule_triangle.h"

#include "proptests/round_laws.h"
#include "proptests/triangle_laws.h"
#include "robust/mixed/capsule_capsule.h"
#include "robust/polyhedra/segment_triangle.h"

namespace touchstone::proptests::capsule_triangle_tests {

using Row = rows::capsule_triangle;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

/// (0, 0), (4, 0), (0, 3) on the ground.
const Triangle3d corner{{0, 0, 0}, {4, 0, 0}, {0, 0, 3}};

constexpr Worked<Row> worked;

ROUND_LAWS("capsule_triangle")

ROBUST_LAW("capsule_triangle: they meet exactly where the segment meets it, or an edge or an end's ball does", c, t) {
  bool meet = robust::segment_triangle_relation(c.segment, t) != SegmentTriangleRelation::none;
  for (const Segment3d& edge : {Segment3d{t.a, t.b}, Segment3d{t.b, t.c}, Segment3d{t.c, t.a}})
    meet = meet || robust::capsule_capsule(c, {edge, 0}) != disjoint;
  for (const Point3d& end : {c.segment.a, c.segment.b})
    meet = meet || robust::sphere_triangle({end, c.radius}, t) != disjoint;
  return (ask(asked) != disjoint) == meet;
}

LAW("capsule_triangle: one that ends at a corner overlaps, unless its radius is 0", c, t) {
  return ask(Row::Question{{{t.b, c.segment.b}, c.radius}, t}) == (c.radius == 0 ? touching : overlapping);
}

TEST_CASE("capsule_triangle: over the face, through it, beyond an edge and a corner, worked by hand") {
  worked({{{{1, 5, 1}, {1, 9, 1}}, 4}, corner}, disjoint, 9);
  worked({{{{1, 5, 1}, {1, 9, 1}}, 5}, corner}, touching, 0);
  worked({{{{1, 5, 1}, {2, 5, 1}}, 6}, corner}, overlapping, 11);
  worked({{{{-9, 3, 1}, {9, 3, 1}}, 2}, corner}, disjoint, 5);      // neither end is over it
  worked({{{{1, -2, 1}, {1, 3, 1}}, 2}, corner}, overlapping, 4);   // through it
  worked({{{{5, -7, 5.5}, {5, 7, 5.5}}, 4}, corner}, disjoint, 9);  // beyond the middle of an edge by (3, 4)
  worked({{{{5, -7, 5.5}, {5, 7, 5.5}}, 5}, corner}, touching, 0);
  worked({{{{-2, 1, -2}, {-4, 2, -4}}, 2}, corner}, disjoint, 5);
  worked({{{{-2, 1, -2}, {-4, 2, -4}}, 3}, corner}, touching, 0);
}

TEST_CASE("capsule_triangle: segments, points, and triangles without area") {
  worked({{{{1, -2, 1}, {1, 3, 1}}, 0}, corner}, touching, 0);
  worked({{{{2, 0, 1}, {9, 0, 9}}, -0.0}, corner}, touching, 0);  // in one plane
  worked({{{{1, 5, 1}, {1, 5, 1}}, 5}, corner}, touching, 0);
  const Triangle3d line{{0, 0, 0}, {10, 0, 0}, {5, 0, 0}}, point{{2, 2, 2}, {2, 2, 2}, {2, 2, 2}};
  worked({{{{3, 4, -9}, {3, 4, 9}}, 5}, line}, overlapping, 9);
  worked({{{{-20, 4, 0}, {30, 4, 0}}, 4}, line}, touching, 0, "algorithm");  // every edge is parallel to it
  worked({{{{0, 0, 0}, {4, 4, 4}}, 0}, point}, touching, 0, "algorithm");
}

TEST_CASE("capsule_triangle: rounding, huge and subnormal") {
  worked({{{{0x1p27, 1, 0}, {0x1p28, 1, 0}}, 0x1p27}, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}}, disjoint, 1, "rounding");
  const Triangle3d level{{-1, 0, 0}, {1, 0, -1}, {1, 0, 1}};
  worked({{{{0, huge, 0}, {0, greatest, 0}}, huge}, level}, touching, 0);  // all squares are infinite
  worked({{{{0, 0, 0}, {0, 1, 0}}, tiny}, level}, overlapping, Rational(exact(tiny) * exact(tiny)), "rounding");
}

TEST_CASE("capsule_triangle: numbers are refused first, then the radius") {
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, -1}, corner}, "capsule.radius", "radius >= 0");
  refused<Row>({{{{0, 0, 0}, {1, 0, 0}}, -1}, {{0, 0, 0}, {1, infinity, 0}, {0, 0, 1}}}, "triangle[1][1]",
               "finite number");
}

CONTRACT("capsule_triangle: where the formula in double is certain by its contract it answers disjoint", capsule, t) {
  const auto& [p, q] = capsule.segment;
  const double r = capsule.radius;
  const SideBound of_p(t, p), of_q(t, q);
  if (truth.answer != disjoint || of_p.overflow || of_q.overflow || !finite(r * r)) return true;
  const auto certain = [](const SideBound& side) { return size(side.computed) > side.error; };
  if (!certain(of_p) || !certain(of_q) || (of_p.computed > 0) != (of_q.computed > 0)) return true;
  if (!certainly_beyond_a(p, t) || !certainly_beyond_a(q, t)) return true;
  return is_apart_where_certain(truth, answer, Row::Question{{capsule.segment, 0}, t}, 6, r);
}

}  // namespace touchstone::proptests::capsule_triangle_tests
