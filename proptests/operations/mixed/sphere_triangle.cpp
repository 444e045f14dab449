// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/sphere_triangle.h"

#include "proptests/round_laws.h"
#include "proptests/space_laws.h"
#include "proptests/triangle_laws.h"
#include "robust/mixed/sphere_capsule.h"
#include "robust/polyhedra/segment_triangle.h"
#include "robust/volumes/sphere_sphere.h"

namespace touchstone::proptests::sphere_triangle_tests {

using Row = rows::sphere_triangle;

constexpr Contact disjoint = Contact::disjoint, touching = Contact::touching, overlapping = Contact::overlapping;

/// (0, 0), (4, 0), (0, 3) on the ground.
const Triangle3d corner{{0, 0, 0}, {4, 0, 0}, {0, 0, 3}};

constexpr Worked<Row> worked;

ROUND_LAWS("sphere_triangle")

ROBUST_LAW("sphere_triangle: a ball that meets a corner or an edge meets the triangle", ball, t) {
  const Contact contact = ask(asked);
  for (const Segment3d& edge : {Segment3d{t.a, t.b}, Segment3d{t.b, t.c}, Segment3d{t.c, t.a}}) {
    const Contact with_edge = robust::sphere_capsule(ball, {edge, 0}),
                  with_end = robust::sphere_sphere(ball, {edge.a, 0});
    if (with_end != disjoint && with_edge == disjoint) return false;
    if (with_edge != disjoint && contact == disjoint) return false;
  }
  return true;
}

ROBUST_LAW("sphere_triangle: a ball of radius 0 touches exactly the triangle that holds its center", ball, t) {
  const bool in = robust::segment_triangle_relation({ball.center, ball.center}, t) != SegmentTriangleRelation::none;
  return ask(Row::Question{{ball.center, 0}, t}) == (in ? touching : disjoint);
}

LAW("sphere_triangle: a ball around a corner overlaps, unless its radius is 0", ball, t) {
  return ask(Row::Question{{t.b, ball.radius}, t}) == (ball.radius == 0 ? touching : overlapping);
}

TEST_CASE("sphere_triangle: face, edge and corner worked by hand") {
  worked({{{1, 5, 1}, 4}, corner}, disjoint, 9);  // over the face
  worked({{{1, 5, 1}, 5}, corner}, touching, 0);
  worked({{{1, 5, 1}, 6}, corner}, overlapping, 11);
  worked({{{1, 0, 1}, 2}, corner}, overlapping, 4);  // its center in it
  worked({{{2, 4, -3}, 5}, corner}, touching, 0);    // beyond an edge
  worked({{{2, 4, -3}, 4}, corner}, disjoint, 9);
  worked({{{-2, 1, -2}, 3}, corner}, touching, 0);  // beyond a corner
  worked({{{-2, 1, -2}, 4}, corner}, overlapping, 7);
}

TEST_CASE("sphere_triangle: a point, and triangles without area") {
  worked({{{1, 0, 1}, 0}, corner}, touching, 0);
  worked({{{1, 0, 1}, -0.0}, corner}, touching, 0);
  worked({{{1, tiny, 1}, 0}, corner}, disjoint, Rational(exact(tiny) * exact(tiny)), "rounding");
  worked({{{3, 4, 0}, 4}, {{0, 0, 0}, {10, 0, 0}, {5, 0, 0}}}, touching, 0);
  worked({{{3, 4, 0}, 5}, {{0, 0, 0}, {0, 0, 0}, {10, 0, 0}}}, overlapping, 9, "algorithm");  // 0 / 0
  worked({{{1, 2, 2}, 3}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}, touching, 0);
}

TEST_CASE("sphere_triangle: rounding, huge and subnormal") {
  worked({{{0x1p27, 1, 0}, 0x1p27}, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}}, disjoint, 1, "rounding");
  worked({{{0, huge, 0}, huge}, {{-1, 0, 0}, {1, 0, -1}, {1, 0, 1}}}, touching, 0);  // both squares are infinite
  worked({{{0, 0, 0}, tiny}, {{-1, 0, 0}, {1, 0, -1}, {1, 0, 1}}}, overlapping, Rational(exact(tiny) * exact(tiny)),
         "rounding");
}

CONTRACT("sphere_triangle: beyond the corner a the formula in double keeps its contract", ball, t) {
  const Vector3d displacement = t.a - ball.center;
  if (!finite(dot(displacement, displacement), ball.radius * ball.radius)) return true;
  if (!certainly_beyond_a(ball.center, t)) return true;
  const Rational u = unit();
  const auto [s, r] = squares(ball, Sphere3d{t.a, 0});
  return abs(s - r) <= (5 + 11 * u) * u * s + u * r + power_of_two(-1072) ||
         (answer == truth.answer && answer == (s > r ? disjoint : overlapping));
}

}  // namespace touchstone::proptests::sphere_triangle_tests
