// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/ray_triangle.h"

#include "proptests/ray_laws.h"
#include "proptests/triangle_laws.h"
#include "robust/mixed/ray_plane.h"
#include "robust/polyhedra/segment_triangle.h"

namespace touchstone::proptests::ray_triangle_tests {
namespace {

using Row = rows::ray_triangle;
using Exact = exact_answer_t<Row>;
using Relation = SegmentTriangleRelation;

const Exact none{Relation::none, {}, {}, {}};
Exact inside(const Rational& t, const Point3<Rational>& point) { return {Relation::point, t, point, Location::inside}; }
Exact boundary(const Rational& t, const Point3<Rational>& point) {
  return {Relation::point, t, point, Location::boundary};
}
Exact segment(const Rational& t, const Point3<Rational>& first) { return {Relation::segment, t, first, {}}; }

constexpr Worked<Row> worked;
constexpr Triangle3d flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};  // x, y >= 0, x + y <= 4
constexpr Triangle3d thin{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}};  // the segment from 0 to 4
constexpr Triangle3d dot_at_1{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};

Ray3d upright(double x, double y, double from, double rise) { return {{x, y, from}, {0, 0, rise}}; }

}  // namespace

LAW("ray_triangle: the order and the number of a triangle's corners do not matter", r, t) {
  const auto answer = ask(asked);
  return equal(answer, ask(Row::Question{r, {t.b, t.c, t.a}})) && equal(answer, ask(Row::Question{r, {t.b, t.a, t.c}}));
}

LAW("ray_triangle: from a corner a ray meets the triangle at t = 0, at its boundary", r, t) {
  const auto answer = ask(Row::Question{{t.b, r.direction}, t});
  return answer.relation != Relation::none && *answer.t == 0 &&
         (answer.relation == Relation::segment || *answer.location == Location::boundary);
}

LAW("ray_triangle: what an edge meets, the triangle meets, and not later; what only the triangle meets is inside", r,
    t) {
  const auto answer = ask(asked);
  bool on_edge = false;
  for (const auto& [from, to] : {std::pair{t.a, t.b}, std::pair{t.b, t.c}, std::pair{t.c, t.a}}) {
    const auto of_edge = ask(Row::Question{r, {from, to, to}});
    if (of_edge.relation > answer.relation || (of_edge.t && *of_edge.t < *answer.t)) return false;
    on_edge = on_edge || of_edge.relation != Relation::none;
  }
  return answer.relation != Relation::point || on_edge == (*answer.location == Location::boundary);
}

ROBUST_LAW("ray_triangle: on the lattice a ray meets what the segment of its direction meets", r, t) {
  if (!on_small_lattice(asked)) return true;
  const auto answer = ask(asked);
  const auto part = robust::segment_triangle({r.origin, r.origin + r.direction}, t);
  if (part.relation == Relation::none) return !answer.t || *answer.t >= 1;
  if (part.relation == Relation::segment)
    return answer.relation == part.relation && equal(*answer.point, part.overlap->a);
  return answer.t == part.t && equal(answer.point, part.point);
}

ROBUST_LAW("ray_triangle: a ray crosses a triangle no more often than the plane of its three corners", r, t) {
  if (!on_small_lattice(asked)) return true;
  const auto in_bits = [](double x) { return std::fabs(x) <= 0x1p12; };
  for (const double x : numbers_of(t)) {
    if (!in_bits(x)) return true;
  }
  const Vector3d n = cross(t.b - t.a, t.c - t.a);
  if (n.x == 0 && n.y == 0 && n.z == 0) return true;
  const auto crossed = robust::ray_plane(r, {n, -dot(n, Vector3d{t.a.x, t.a.y, t.a.z})});
  const auto answer = ask(asked);
  if (answer.relation == Relation::none) return true;
  return crossed.relation == LinePlaneRelation::inside ||
         (equal(answer.t, crossed.t) && equal(answer.point, crossed.point));
}

TEST_CASE("ray_triangle: p. 54's crossing with a ray, worked by hand; margin: the origin, or the nearest edge") {
  worked({upright(1, 1, -1, 2), flat}, inside(Rational(1, 2), {1, 1, 0}), 1);
  worked({upright(1, 1, 3, -4), flat}, inside(Rational(3, 4), {1, 1, 0}), 1);
  worked({upright(1, 1, -1, 0x1p-20), flat}, inside(0x1p20, {1, 1, 0}), 1);
  worked({upright(1, 1, 1, 3), flat}, none, 1);  // away
  worked({upright(1, 1, -3, -2), flat}, none, 9);
  worked({upright(3, 3, -1, 1), flat}, none, 2);                                   // beyond x + y = 4, by the root of 2
  worked({upright(-2, 1, -1, 1), flat}, none, 4);                                  // beyond x = 0
  worked({{{1, -1, -1}, {0, 2, 1}}, flat}, inside(1, {1, 1, 0}), Rational(1, 5));  // y = 0 at z = -1/2
}

TEST_CASE("ray_triangle: origin, edges and corners belong to them") {
  worked({upright(1, 1, 0, 3), flat}, inside(0, {1, 1, 0}), 0);
  worked({upright(2, 2, -1, 1), flat}, boundary(1, {2, 2, 0}), 0);               // on an edge
  worked({upright(4, 0, -1, 4), flat}, boundary(Rational(1, 4), {4, 0, 0}), 0);  // through a corner
  worked({upright(0, 0, 0, 1), flat}, boundary(0, {0, 0, 0}), 0);                // from a corner
}

TEST_CASE("ray_triangle: the formula has no ray in the plane") {
  worked({{{1, -1, 0}, {0, 2, 0}}, flat}, segment(Rational(1, 2), {1, 0, 0}), 0, "algorithm");
  worked({{{1, 1, 0}, {1, 0, 0}}, flat}, segment(0, {1, 1, 0}), 0, "algorithm");                  // from within
  worked({{{-3, 0, 0}, {3, 0, 0}}, flat}, segment(1, {0, 0, 0}), 0, "algorithm");                 // along an edge
  worked({{{-1, 1, 0}, {2, -2, 0}}, flat}, boundary(Rational(1, 2), {0, 0, 0}), 0, "algorithm");  // by a corner
  worked({{{4, 0, 0}, {5, 0, 0}}, flat}, boundary(0, {4, 0, 0}), 0, "algorithm");                 // away from one
  worked({{{5, 0, 0}, {1, 0, 0}}, flat}, none, 1);
  worked({{{3, 3, 0}, {1, 1, 0}}, flat}, none, 2);
}

TEST_CASE("ray_triangle: a triangle without area is what its corners span, all of it boundary") {
  worked({{{3, -1, 0}, {0, 2, 0}}, thin}, boundary(Rational(1, 2), {3, 0, 0}), 0, "algorithm");
  worked({{{3, -1, 1}, {0, 2, 0}}, thin}, none, 1);
  worked({{{-1, 0, 0}, {2, 0, 0}}, thin}, segment(Rational(1, 2), {0, 0, 0}), 0, "algorithm");
  worked({{{6, 0, 0}, {1, 0, 0}}, thin}, none, 4);
  worked({{{0, 0, 0}, {4, 4, 4}}, dot_at_1}, boundary(Rational(1, 4), {1, 1, 1}), 0, "algorithm");
  worked({{{1, 1, 3}, {0, 0, 2}}, dot_at_1}, none, 4);
}

CONTRACT("ray_triangle: the formula in double keeps its contract", ray, triangle) {
  const SideBound at_origin(triangle, ray.origin), rise(triangle, ray.direction);
  if (at_origin.overflow || rise.overflow) return true;
  const Rational e0 = exact(at_origin.computed), r = exact(rise.computed);
  if (abs(e0) <= at_origin.error || abs(r) <= rise.error) return true;
  if (sgn(e0) == sgn(r)) {
    if (!(abs(e0) > power_of_two(-1074) * abs(r))) return true;
    return answer.relation == Relation::none && truth.answer.relation == Relation::none;
  }
  if (answer.relation != Relation::point || truth.answer.relation != Relation::point) return true;
  if (!finite(*answer.t)) return true;
  const Rational error = error_of_quotient(*answer.t, at_origin.error, rise.computed, rise.error);
  return within(*answer.t, *truth.answer.t, error) &&
         close_along(ray.direction, *answer.t, error, *answer.point, *truth.answer.point);
}

}  // namespace touchstone::proptests::ray_triangle_tests
