// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polyhedra/segment_triangle.h"

#include <array>

#include "catalogue/families/meshes/reported_meshes.h"
#include "proptests/triangle_laws.h"

namespace touchstone::proptests::segment_triangle_tests {
namespace {

using Row = rows::segment_triangle;
using Exact = exact_answer_t<Row>;
using Relation = SegmentTriangleRelation;

const Exact none{Relation::none, {}, {}, {}};
Exact point(const Rational& t, const Rational& x, const Rational& y, const Rational& z) {
  return {Relation::point, t, Point3<Rational>{x, y, z}, {}};
}
Exact overlap(const Point3<Rational>& first, const Point3<Rational>& last) {
  return {Relation::segment, {}, {}, Segment3<Rational>{first, last}};
}

constexpr Worked<Row> worked;
constexpr Triangle3d flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};  // x, y >= 0, x + y <= 4
constexpr Triangle3d thin{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}};  // the segment from 0 to 4
constexpr Triangle3d dot_at_1{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}};

Segment3d upright(double x, double y, double below, double above) { return {{x, y, below}, {x, y, above}}; }

}  // namespace

LAW("segment_triangle: the order and the number of a triangle's corners do not matter", s, t) {
  const auto answer = ask(asked);
  return equal(answer, ask(Row::Question{s, {t.b, t.c, t.a}})) && equal(answer, ask(Row::Question{s, {t.b, t.a, t.c}}));
}

LAW("segment_triangle: the reversed segment has the same part in common, reversed", s, t) {
  const auto answer = ask(asked), found = ask(Row::Question{{s.b, s.a}, t});
  const bool turned = s.a == s.b ? equal(answer.t, found.t) : reversed(answer.t, found.t);
  return answer.relation == found.relation && turned && equal(answer.point, found.point) &&
         (!answer.overlap ||
          (equal(answer.overlap->a, found.overlap->b) && equal(answer.overlap->b, found.overlap->a)));
}

LAW("segment_triangle: corners meet the triangle, and a segment of the triangle lies in it", s, t) {
  const auto at_corner = ask(Row::Question{{t.b, t.b}, t});
  const auto edge = ask(Row::Question{{t.a, t.b}, t});
  return at_corner.relation == Relation::point && edge.relation == (t.a == t.b ? Relation::point : Relation::segment);
}

LAW("segment_triangle: what an edge meets, the triangle meets", s, t) {
  const auto of_edge = ask(Row::Question{s, {t.a, t.b, t.b}});
  return of_edge.relation <= ask(asked).relation;
}

TEST_CASE("segment_triangle: p. 54's ends on opposite sides, worked by hand") {
  // t is how much of the way the plane z = 0 is away; margin: the edge x = 0 is 1 away, as are y = 0 and the ends.
  worked({upright(1, 1, -1, 1), flat}, point(Rational(1, 2), 1, 1, 0), 1);
  worked({upright(1, 1, 3, -1), flat}, point(Rational(3, 4), 1, 1, 0), 1);
  worked({upright(1, 1, 1, 3), flat}, none, 1);    // both in front
  worked({upright(1, 1, -3, -2), flat}, none, 4);  // both behind
  worked({upright(3, 3, -1, 1), flat}, none, 2);   // beyond x + y = 4, by the root of 2
  worked({upright(-2, 1, -1, 1), flat}, none, 4);  // beyond x = 0
  worked({{{1, -1, -1}, {1, 3, 1}}, flat}, point(Rational(1, 2), 1, 1, 0), Rational(1, 5));  // y = 0 at z = -1/2
}

TEST_CASE("segment_triangle: ends, edges and corners belong to them") {
  worked({upright(1, 1, 0, 3), flat}, point(0, 1, 1, 0), 0);
  worked({upright(1, 1, -2, 0), flat}, point(1, 1, 1, 0), 0);
  worked({upright(2, 2, -1, 1), flat}, point(Rational(1, 2), 2, 2, 0), 0);  // on an edge
  worked({upright(4, 0, -1, 3), flat}, point(Rational(1, 4), 4, 0, 0), 0);  // through a corner
  worked({upright(0, 0, 0, 1), flat}, point(0, 0, 0, 0), 0);                // corner on end
}

TEST_CASE("segment_triangle: the rays of a public report, through a cube along its axes") {
  const Meshd cube = catalogue::reported::edyn_155();
  for (const std::size_t axis : {0, 1, 2}) {
    for (const Face& f : cube.faces) {
      const auto at = [axis](double n) { return Point3d{axis == 0 ? n : 0, axis == 1 ? n : 0, axis == 2 ? n : 0}; };
      const auto along = [&](Index i) {
        const Point3d& p = cube.vertices[i];
        return std::array{p.x, p.y, p.z}[axis];
      };
      // From 2 to -2: a side at 1 is a quarter of the way, one at -1 three quarters. The other sides are in planes
      // parallel to the ray, 1 from it.
      const bool across = along(f.a) == along(f.b) && along(f.b) == along(f.c);
      const Row::Question question{{at(2), at(-2)}, {cube.vertices[f.a], cube.vertices[f.b], cube.vertices[f.c]}};
      if (!across) {
        worked(question, none, 1);
      } else {
        const Point3d p = at(along(f.a));
        worked(question, point(Rational(along(f.a) > 0 ? 1 : 3, 4), p.x, p.y, p.z), 0);
      }
    }
  }
}

TEST_CASE("segment_triangle: the formula has no segment in the plane") {
  worked({{{1, -1, 0}, {1, 5, 0}}, flat}, overlap({1, 0, 0}, {1, 3, 0}), 0, "algorithm");
  worked({{{1, 5, 0}, {1, -1, 0}}, flat}, overlap({1, 3, 0}, {1, 0, 0}), 0, "algorithm");
  worked({{{1, 1, 0}, {2, 1, 0}}, flat}, overlap({1, 1, 0}, {2, 1, 0}), 0, "algorithm");   // within
  worked({{{-3, 0, 0}, {3, 0, 0}}, flat}, overlap({0, 0, 0}, {3, 0, 0}), 0, "algorithm");  // along an edge
  worked({{{-1, 1, 0}, {1, -1, 0}}, flat}, point(Rational(1, 2), 0, 0, 0), 0, "algorithm");
  worked({{{4, 0, 0}, {9, 0, 0}}, flat}, point(0, 4, 0, 0), 0, "algorithm");
  worked({{{5, 0, 0}, {9, 0, 0}}, flat}, none, 1);
  worked({{{3, 3, 0}, {5, 5, 0}}, flat}, none, 2);
}

TEST_CASE("segment_triangle: a segment of length zero is a point, a triangle without area what its corners span") {
  worked({{{1, 1, 0}, {1, 1, 0}}, flat}, point(0, 1, 1, 0), 0, "algorithm");
  worked({{{1, 1, 2}, {1, 1, 2}}, flat}, none, 4);
  worked({{{3, -1, 0}, {3, 1, 0}}, thin}, point(Rational(1, 2), 3, 0, 0), 0, "algorithm");
  worked({{{3, -1, 1}, {3, 1, 1}}, thin}, none, 1);
  worked({{{-1, 0, 0}, {9, 0, 0}}, thin}, overlap({0, 0, 0}, {4, 0, 0}), 0, "algorithm");
  worked({{{6, 0, 0}, {9, 0, 0}}, thin}, none, 4);
  worked({{{0, 0, 0}, {4, 4, 4}}, dot_at_1}, point(Rational(1, 4), 1, 1, 1), 0, "algorithm");
  worked({{{1, 1, 1}, {1, 1, 1}}, dot_at_1}, point(0, 1, 1, 1), 0, "algorithm");
  worked({{{1, 1, 3}, {1, 1, 2}}, dot_at_1}, none, 1);
}

CONTRACT("segment_triangle: the formula in double keeps its contract", segment, triangle) {
  const SideBound p(triangle, segment.a), q(triangle, segment.b);
  if (p.overflow || q.overflow) return true;
  const Rational at_p = exact(p.computed), at_q = exact(q.computed);
  if (abs(at_p) <= p.error || abs(at_q) <= q.error) return true;
  if (sgn(at_p) == sgn(at_q)) return answer.relation == Relation::none && truth.answer.relation == Relation::none;
  if (answer.relation != Relation::point || truth.answer.relation != Relation::point) return true;
  const Rational error =
      (p.error + q.error) / (abs(at_p) + abs(at_q)) + 3 * unit() * size(*answer.t) + power_of_two(-1073);
  return !finite(p.computed - q.computed) || within(*answer.t, *truth.answer.t, error);
}

}  // namespace touchstone::proptests::segment_triangle_tests
