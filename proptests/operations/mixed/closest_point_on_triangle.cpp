// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/closest_point_on_triangle.h"

#include "proptests/triangle_laws.h"
#include "robust/mixed/closest_point_on_segment.h"
#include "robust/polyhedra/segment_triangle.h"

namespace touchstone::proptests::closest_point_on_triangle_tests {
namespace {

using Row = rows::closest_point_on_triangle;

/// (0, 0), (4, 0), (0, 3) on the ground.
const Triangle3d corner{{0, 0, 0}, {4, 0, 0}, {0, 0, 3}};

void worked(const Point3d& p, const Triangle3d& t, const Point3<Rational>& nearest, const Rational& distance,
            const std::string& by_reference = "agree") {
  example<Row>({p, t},
               ClosestPoint3<oracle::Surd>{{nearest.x, nearest.y, nearest.z}, Rational(distance * distance), distance},
               by_reference);
}
constexpr RoundsTo<Row> rounds_to;

}  // namespace

LAW("closest_point_on_triangle: the order of the corners does not matter", p, t) {
  const auto found = ask(asked);
  return equal(found, ask(Row::Question{p, {t.b, t.c, t.a}})) && equal(found, ask(Row::Question{p, {t.c, t.b, t.a}}));
}

LAW("closest_point_on_triangle: no corner is nearer, and each is nearest to itself", p, t) {
  for (const Point3d& q : {t.a, t.b, t.c}) {
    if (ask(asked).squared_distance > ask(Row::Question{p, {q, q, q}}).squared_distance) return false;
    if (!is_zero(ask(Row::Question{q, t}).distance)) return false;
  }
  return true;
}

ROBUST_LAW("closest_point_on_triangle: no edge is nearer, and a triangle of two corners is a segment", p, t) {
  const auto found = ask(asked);
  for (const Segment3d& edge : {Segment3d{t.a, t.b}, Segment3d{t.b, t.c}, Segment3d{t.c, t.a}}) {
    const auto on_edge = robust::closest_point_on_segment(p, edge);
    if (found.squared_distance > on_edge.squared_distance) return false;
    if (!equal(ask(Row::Question{p, {edge.a, edge.b, edge.b}}), on_edge)) return false;
  }
  return true;
}

ROBUST_LAW("closest_point_on_triangle: a point of the triangle has the distance 0", p, t) {
  const auto found = ask(asked);
  return robust::segment_triangle_relation({p, p}, t) == SegmentTriangleRelation::none ||
         (found.distance == 0 && equal(found.point, p));
}

LENGTHS_LAW("closest_point_on_triangle")

LAW("closest_point_on_triangle: the formula is right in exact arithmetic, but for a == b and an acute angle there", p,
    t) {
  const Point3<Rational> q = exact_point(p), a = exact_point(t.a), b = exact_point(t.b), c = exact_point(t.c);
  if (a == b && sgn(dot(c - a, q - a)) > 0) return true;
  const Point3<Rational> x = reference::nearest_of_triangle<Rational>(q, {a, b, c});
  const auto found = ask(asked).point;
  return catalogue::nearest(x.x) == rounded(found.x) && catalogue::nearest(x.y) == rounded(found.y) &&
         catalogue::nearest(x.z) == rounded(found.z);
}

TEST_CASE("closest_point_on_triangle: face, edges and corners worked by hand") {
  worked({1, 5, 1}, corner, {1, 0, 1}, 5);      // over the face
  worked({1, -5, 1}, corner, {1, 0, 1}, 5);     // below it
  worked({1, 0, 1}, corner, {1, 0, 1}, 0);      // in it
  worked({1, 0, 0}, corner, {1, 0, 0}, 0);      // on an edge
  worked({4, 0, 0}, corner, {4, 0, 0}, 0);      // a corner
  worked({2, 4, -3}, corner, {2, 0, 0}, 5);     // beyond the edge a, b
  worked({-3, 4, 1}, corner, {0, 0, 1}, 5);     // beyond the edge c, a
  worked({5, 0, 5.5}, corner, {2, 0, 1.5}, 5);  // beyond the edge b, c, along its normal (3, 4) / 5
  worked({-2, 1, -2}, corner, {0, 0, 0}, 3);    // beyond each corner
  worked({6, -1, -2}, corner, {4, 0, 0}, 3);
  worked({-2, 1, 5}, corner, {0, 0, 3}, 3);
}

TEST_CASE("closest_point_on_triangle: without area it is a segment or a point") {
  worked({3, 4, 0}, {{0, 0, 0}, {10, 0, 0}, {5, 0, 0}}, {3, 0, 0}, 4);
  worked({7, 4, 0}, {{0, 0, 0}, {5, 0, 0}, {10, 0, 0}}, {7, 0, 0}, 4);
  worked({-3, 4, 0}, {{0, 0, 0}, {5, 0, 0}, {10, 0, 0}}, {0, 0, 0}, 5);
  worked({7, 4, 0}, {{0, 0, 0}, {10, 0, 0}, {10, 0, 0}}, {7, 0, 0}, 4);
  worked({7, 4, 0}, {{0, 0, 0}, {0, 0, 0}, {10, 0, 0}}, {7, 0, 0}, 4, "invalid");  // 0 / 0
  worked({-3, 4, 0}, {{0, 0, 0}, {0, 0, 0}, {10, 0, 0}}, {0, 0, 0}, 5);
  worked({1, 2, 2}, {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}, {0, 0, 0}, 3);
}

TEST_CASE("closest_point_on_triangle: rounding, huge and subnormal") {
  rounds_to({{1, 1, 1}, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}}, {0, 0, 0, 3, 0x1.bb67ae8584caap+0});  // root of 3
  rounds_to({{huge, huge, huge}, {{0, 0, 0}, {-1, 0, 0}, {0, -1, 0}}}, {0, 0, 0, infinity, 0x1.ed4df0150215ap+1023});
  rounds_to({{3 * tiny, 0, 0}, {{0, 0, -1}, {4 * tiny, 4 * tiny, -1}, {0, 0, 1}}},
            {2 * tiny, 2 * tiny, 0, 0, 2 * tiny});
  const double x = 0x1p52 + 1;
  rounds_to({{x + 1, 0, 0}, {{x, 0, -64}, {x + 64, 64, -64}, {x, 0, 64}}},
            {0x1p52 + 2, 0.5, 0, 0.5, 0x1.6a09e667f3bcdp-1});
  rounds_to({{x + 1, -0x1p-60, 0}, {{x, 0, -64}, {x + 64, 64, -64}, {x, 0, 64}}},
            {x, 0.5, 0, 0.5, 0x1.6a09e667f3bcdp-1});
}

CONTRACT("closest_point_on_triangle: beyond a the formula in double keeps its contract", p, t) {
  const Vector3d displacement = p - t.a;
  if (!finite(dot(displacement, displacement)) || !certainly_beyond_a(p, t)) return true;
  const Rational u = unit();
  const Rational& square = truth.answer.squared_distance.rational_part();
  return equal(answer.point, t.a) && catalogue::nearest(truth.answer.point.x) == t.a.x &&
         abs(exact(answer.squared_distance) - square) <= (5 + 11 * u) * u * square + power_of_two(-1072);
}

}  // namespace touchstone::proptests::closest_point_on_triangle_tests
