// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/mixed/triangle_triangle_distance.h"

#include "proptests/triangle_laws.h"
#include "robust/mixed/closest_point_on_triangle.h"
#include "robust/mixed/segment_segment_distance.h"
#include "robust/polyhedra/triangle_triangle.h"

namespace touchstone::proptests::triangle_triangle_distance_tests {
namespace {

using Row = rows::triangle_triangle_distance;
using Answer = exact_answer_t<Row>;
using Point = Point3<Rational>;

constexpr Worked<Row> worked;
constexpr RoundsTo<Row> rounds_to;
constexpr Triangle3d flat{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}};  // x, y >= 0, x + y <= 4
constexpr Triangle3d thin{{0, 0, 0}, {4, 0, 0}, {1, 0, 0}};  // the segment from 0 to 4

const Answer meets{ConvexRelation::meeting, {}, {}, {}, {}};
Answer apart(const Point& on_a, const Point& on_b, const Rational& distance) {
  const auto with_roots = [](const Point& p) { return Point3<oracle::Surd>{p.x, p.y, p.z}; };
  return {ConvexRelation::apart, with_roots(on_a), with_roots(on_b), Rational(distance * distance), distance};
}
/// The margin is the squared distance.
void far(const Triangle3d& a, const Triangle3d& b, const Point& on_a, const Point& on_b, const Rational& distance,
         const std::string& by_reference = "agree") {
  worked({a, b}, apart(on_a, on_b, distance), Rational(distance * distance), by_reference);
}

bool has_area(const Triangle3d& t) {
  const Point a = exact_point(t.a);
  const Vector3<Rational> n = cross(exact_point(t.b) - a, exact_point(t.c) - a);
  return sgn(dot(n, n)) != 0;
}

}  // namespace

LAW("triangle_triangle_distance: no order matters, but which corner of a is the first, and for the points which is a",
    a, b) {
  const auto answer = ask(asked);
  const auto as_far = [&](const Row::Question& other) {
    const auto found = ask(other);
    return found.relation == answer.relation && found.squared_distance == answer.squared_distance &&
           found.distance == answer.distance;
  };
  return equal(ask(Row::Question{{a.a, a.c, a.b}, b}), answer) &&
         equal(ask(Row::Question{a, {b.c, b.a, b.b}}), answer) && as_far({{a.b, a.c, a.a}, b}) && as_far({b, a});
}

LAW("triangle_triangle_distance: it is 0 where they meet, and there are points where they do not") {
  const auto answer = ask(asked);
  const bool apart = answer.relation == ConvexRelation::apart;
  if (!apart && (!is_zero(answer.squared_distance) || !is_zero(answer.distance))) return false;
  return answer.on_a.has_value() == apart && answer.on_b.has_value() == apart;
}

ROBUST_LAW("triangle_triangle_distance: triangles without a common point are as far as the nearest corner or edges", a,
           b) {
  const auto answer = ask(asked);
  const bool meet = robust::triangle_triangle(a, b) != TriangleTriangleRelation::none;
  if (meet || answer.relation == ConvexRelation::meeting) return meet && answer.relation == ConvexRelation::meeting;
  double least = infinity, square = infinity;
  const auto try_next = [&](const auto& found) {
    least = std::min(least, found.distance), square = std::min(square, found.squared_distance);
  };
  const auto edges = [](const Triangle3d& t) { return std::array<Segment3d, 3>{{{t.a, t.b}, {t.b, t.c}, {t.c, t.a}}}; };
  for (const Segment3d& s : edges(a)) {
    try_next(robust::closest_point_on_triangle(s.a, b));
    for (const Segment3d& r : edges(b)) try_next(robust::segment_segment_distance(s, r));
  }
  for (const Segment3d& r : edges(b)) try_next(robust::closest_point_on_triangle(r.a, a));
  return answer.distance == least && answer.squared_distance == square;
}

LENGTHS_LAW("triangle_triangle_distance")

ROBUST_LAW("triangle_triangle_distance: the formula has the right distance in exact arithmetic, but without area", a,
           b) {
  if (!has_area(a) || !has_area(b)) return true;
  const auto exactly = [](const Triangle3d& t) {
    return catalogue::converted<catalogue::Exact>(t, [](double number) { return catalogue::Exact(exact(number)); });
  };
  const auto formula = reference::triangle_triangle_distance(exactly(a), exactly(b));
  const auto answer = ask(asked);
  return formula.relation == answer.relation &&
         catalogue::nearest(formula.squared_distance.value()) == answer.squared_distance;
}

TEST_CASE("triangle_triangle_distance: corner to face, edge and corner, worked by hand") {
  const Triangle3d over{{1, 1, 3}, {2, 1, 5}, {1, 2, 5}};
  far(flat, over, {1, 1, 0}, {1, 1, 3}, 3);
  far(over, flat, {1, 1, 3}, {1, 1, 0}, 3);
  far(flat, {{2, -3, 4}, {2, -5, 4}, {3, -5, 9}}, {2, 0, 0}, {2, -3, 4}, 5);
  far(flat, {{-2, -3, -6}, {-2, -4, -9}, {-4, -3, -9}}, {0, 0, 0}, {-2, -3, -6}, 7);
}

TEST_CASE("triangle_triangle_distance: edge to edge, worked by hand") {
  // The edge along y passes over the edge along x, 2 above (1, 0, 0).
  far({{0, 0, 0}, {4, 0, 0}, {0, 0, -4}}, {{1, -2, 2}, {1, 2, 2}, {1, 0, 9}}, {1, 0, 0}, {1, 0, 2}, 2);
  // Beside x + y = 4: from its middle 3 along x and y to an edge along z.
  rounds_to({flat, {{5, 5, -1}, {5, 5, 1}, {9, 9, 0}}}, {2, 2, 0, 5, 5, 0, 18, 0x1.0f876ccdf6cd9p+2});
}

TEST_CASE("triangle_triangle_distance: of many nearest pairs the one whose point on a is nearest to a's first corner") {
  const Triangle3d above{{0, 0, 2}, {4, 0, 2}, {0, 4, 2}};
  far(flat, above, {0, 0, 0}, {0, 0, 2}, 2);
  far({flat.b, flat.c, flat.a}, above, {4, 0, 0}, {4, 0, 2}, 2);
  far(flat, {{1, 1, 2}, {8, 1, 2}, {1, 8, 2}}, {1, 1, 0}, {1, 1, 2}, 2);  // a corner of b
  // An edge of b, x + y = 2, and where one, x = 3, is over an edge of a.
  far(flat, {{4, -2, 2}, {-2, 4, 2}, {9, 9, 2}}, {1, 1, 0}, {1, 1, 2}, 2, "algorithm");
  far(flat, {{3, -1, 2}, {3, 9, 2}, {9, -1, 2}}, {3, 0, 0}, {3, 0, 2}, 2, "algorithm");
  // The foot of a's first corner on the edge that is nearest; the edge along another.
  far({{1, 1, -6}, {4, 0, 0}, {0, 4, 0}}, {{0, 0, 2}, {8, 0, 2}, {0, 8, 2}}, {2, 2, 0}, {2, 2, 2}, 2, "algorithm");
  far({{0, 0, -6}, {4, 0, 0}, {0, 0, 0}}, {{1, 0, 2}, {9, 0, 2}, {1, 0, 9}}, {1, 0, 0}, {1, 0, 2}, 2, "algorithm");
}

TEST_CASE("triangle_triangle_distance: what has a common point meets") {
  // It is cut at y = 1, which is 1 from an edge of flat, and reaches 1 below and above it.
  worked({{{1, 1, -1}, {1, 1, 1}, {3, 1, 1}}, flat}, meets, 1);
  worked({{{1, 1, 0}, {2, 1, 2}, {1, 1, 2}}, flat}, meets, 0);    // a corner on the face
  worked({{{0, 0, 0}, {-1, 0, 3}, {0, -1, 3}}, flat}, meets, 0);  // a common corner
  worked({{{2, 2, -1}, {2, 2, 1}, {4, 4, 0}}, flat}, meets, 0);   // edge across edge
  worked({{{1, 1, 0}, {2, 1, 0}, {1, 2, 0}}, flat}, meets, 0);    // inside, in one plane
  worked({{{-1, 1, 0}, {5, 1, 0}, {2, 9, 0}}, flat}, meets, 0);   // across, in one plane
  worked({flat, flat}, meets, 0);
}

TEST_CASE("triangle_triangle_distance: a triangle without area is what its corners span") {
  const Triangle3d dot_at_1{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, dot_at_4{{1, 1, 4}, {1, 1, 4}, {1, 1, 4}};
  far(thin, {{3, 4, -9}, {3, 4, 9}, {3, 4, 0}}, {3, 0, 0}, {3, 4, 0}, 4);
  far(thin, {{6, 0, 0}, {9, 0, 0}, {7, 0, 0}}, {4, 0, 0}, {6, 0, 0}, 2);
  far(dot_at_1, dot_at_4, {1, 1, 1}, {1, 1, 4}, 3);
  far({{0, 0, 0}, {0, 0, 0}, {4, 0, 0}}, {{2, 3, 0}, {2, 3, 0}, {2, 3, 0}}, {2, 0, 0}, {2, 3, 0}, 3, "algorithm");
  worked({thin, {{2, 0, 0}, {2, 0, 0}, {2, 0, 0}}}, meets, 0);
  worked({dot_at_1, dot_at_1}, meets, 0);
}

TEST_CASE("triangle_triangle_distance: rounding, huge and subnormal") {
  const Rational t = exact(tiny);
  worked({{{0, 0, 0}, {4 * tiny, 0, 0}, {0, 4 * tiny, 0}},
          {{tiny, tiny, 3 * tiny}, {2 * tiny, tiny, 5 * tiny}, {tiny, 2 * tiny, 5 * tiny}}},
         apart({t, t, 0}, {t, t, 3 * t}, 3 * t), 9 * t * t, "rounding");
  rounds_to({{{-huge, 0, 0}, {-greatest, 0, 1}, {-greatest, 1, 0}}, {{huge, 0, 0}, {greatest, 0, 1}, {greatest, 1, 0}}},
            {-huge, 0, 0, huge, 0, 0, infinity, infinity});
}

TEST_CASE("triangle_triangle_distance: numbers are refused, those of a first") {
  refused<Row>({{{0, 0, 0}, {1, 0, 0}, {0, not_a_number, 0}}, {{infinity, 0, 0}, {1, 0, 0}, {0, 1, 0}}}, "a[2][1]",
               "finite number");
  refused<Row>({flat, {{0, 0, 0}, {1, 0, -infinity}, {0, 1, 0}}}, "b[1][2]", "finite number");
}

CONTRACT("triangle_triangle_distance: the formula in double keeps its contract", a, b) {
  if (!finite(answer.squared_distance, answer.distance)) return true;
  const Rational u = unit(), distance = exact(answer.distance), least = power_of_two(-536);
  // By squares: D <= (1 + 4u) |a.a - b.a| + 2^-536, and D* <= (D + 2^-536) / (1 - 4u).
  const Vector3<Rational> first = exact_point(a.a) - exact_point(b.a);
  const Rational most(std::max(Rational(0), Rational(distance - least)) / (1 + 4 * u));
  if (most * most > dot(first, first)) return false;
  const auto is_corner = [](const Point3d& p, const Triangle3d& t) { return p == t.a || p == t.b || p == t.c; };
  if (!answer.on_a || !is_corner(*answer.on_a, a) || !is_corner(*answer.on_b, b)) return true;
  const Rational bound((distance + least) / (1 - 4 * u));
  return truth.answer.squared_distance.rational_part() <= bound * bound;
}

}  // namespace touchstone::proptests::triangle_triangle_distance_tests
