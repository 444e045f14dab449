// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/point_in_convex_polygon.h"

#include "proptests/closed_rings.h"
#include "proptests/forward_error.h"
#include "robust/polygons/point_in_convex_polygon.h"
#include "robust/polygons/point_in_polygon.h"
#include "robust/polygons/polygon_convexity.h"

namespace touchstone::proptests::point_in_convex_polygon_tests {
namespace {

using Row = rows::point_in_convex_polygon;

constexpr Location inside = Location::inside, boundary = Location::boundary, outside = Location::outside;

/// Whether every E of the slide is certain by the bound of the contract.
bool certain(const Polygon2d& given, const Point2d& p) {
  const Polygon2d ring = opened(given);
  const Rational u = unit();
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2d &a = ring[i], &b = ring.next(i);
    const double left = (p.y - a.y) * (b.x - a.x), right = (p.x - a.x) * (b.y - a.y);
    if (!finite(left, right, left - right)) return false;
    const Rational bound = (3 + 16 * u) * u * (size(left) + size(right)) + power_of_two(-1073);
    const Rational e =
        (exact(p.y) - exact(a.y)) * (exact(b.x) - exact(a.x)) - (exact(p.x) - exact(a.x)) * (exact(b.y) - exact(a.y));
    if (abs(e) <= bound) return false;
  }
  return true;
}

const Polygon2d square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
const Polygon2d kite{{{0, -4}, {3, 0}, {0, 2}, {-3, 0}}};

}  // namespace

LAW("point_in_convex_polygon: it does not matter where the ring starts, nor in which direction it goes", ring, p) {
  const Location location = ask(asked);
  Polygon2d other = opened(ring);
  std::reverse(other.vertices.begin(), other.vertices.end());
  if (ask(Row::Question{other, p}) != location) return false;
  std::rotate(other.vertices.begin(), other.vertices.begin() + 1, other.vertices.end());
  return ask(Row::Question{other, p}) == location;
}

ROBUST_LAW("point_in_convex_polygon: as the ray test for any ring says", ring, p) {
  return ask(asked) == robust::point_in_polygon(ring, p);
}

LAW("point_in_convex_polygon: vertices are on the boundary, and so is nothing inside a triangle of them", ring, p) {
  for (const Point2d& vertex : ring.vertices) {
    if (ask(Row::Question{ring, vertex}) != boundary) return false;
  }
  const Polygon2d triangle{{ring[0], ring[ring.size() / 3], ring[2 * ring.size() / 3]}};
  if (robust::polygon_convexity(triangle).polygon_class != PolygonClass::convex) return true;
  const Location part = ask(Row::Question{triangle, p}), whole = ask(asked);
  return (part != inside || whole == inside) && (whole != outside || part == outside);
}

TEST_CASE("point_in_convex_polygon: refused exactly where the polygon is not convex") {
  const auto complaint = [](const Question& question) -> std::string {
    const auto asked = typed<Row>(question);
    const auto& [ring, p] = asked;
    if (validation::fewer_than_three(ring.vertices)) return "";
    const bool convex = robust::polygon_convexity(ring).polygon_class == PolygonClass::convex;
    try {
      catalogue::ask_robust<Row>(asked);
      return convex ? "" : "answered";
    } catch (const InvalidInput&) {
      return convex ? "refused" : "";
    }
  };
  never(*catalogue::find_operation(Row::metadata.name), "refused as not convex", complaint, 8);
}

TEST_CASE("point_in_convex_polygon: p. 16's side tests worked by hand") {
  // E of the edges in turn: 4 y, 4 (4 - x), 4 (4 - y), 4 x.
  example<Row>({square, {1, 3}}, inside);
  example<Row>({square, {1, 4}}, boundary);
  example<Row>({square, {4, 4}}, boundary);
  example<Row>({square, {5, 2}}, outside);
  example<Row>({square, {5, 0}}, outside);  // on an edge's line, beyond its end: 0, -4, 16, 20
  // Clockwise: the same with the other sign.
  example<Row>({{{{0, 4}, {4, 4}, {4, 0}, {0, 0}}}, {1, 3}}, inside);
  example<Row>({{{{0, 4}, {4, 4}, {4, 0}, {0, 0}}}, {0, 3}}, boundary);
  example<Row>({{{{0, 4}, {4, 4}, {4, 0}, {0, 0}}}, {-1, 3}}, outside);
  // The kite's edge from (0, -4) to (3, 0): E = 3 (y + 4) - 4 x.
  example<Row>({kite, {1.5, -2}}, boundary);
  example<Row>({kite, {1.5, -2.5}}, outside);
  example<Row>({kite, {1.5, -1.5}}, inside);
  // Flat vertices, also beside vertex 0.
  const Polygon2d flat{{{0, 0}, {1, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 1}}};
  example<Row>({flat, {2, 0}}, boundary);
  example<Row>({flat, {0, 2}}, boundary);
  example<Row>({flat, {1, 1}}, inside);
  example<Row>({flat, {2, 2}}, inside);
  example<Row>({flat, {-1, 0}}, outside);
}

TEST_CASE("point_in_convex_polygon: a last position that repeats the first is dropped, once") {
  const Polygon2d ring = closed(square);
  example<Row>({ring, {1, 3}}, inside);
  example<Row>({ring, {0, 0}}, boundary);
  example<Row>({ring, {0, 2}}, boundary);
  example<Row>({ring, {5, 0}}, outside);
  example<Row>({{{{0, 0}, {4, 0}, {0, 4}, {-0.0, 0}}}, {1, 1}}, inside);
  refused<Row>({{{{0, 0}, {1, 1}, {2, 2}, {0, 0}}}, {1, 1}}, "polygon", "convex: vertices on one line have no inside");
}

TEST_CASE("point_in_convex_polygon: rounding, huge, subnormal and negative zero") {
  // 0.1 as a double is 3602879701896397 / 2^55: (1, 0.1) lies 2^-54 left of the edge from (10, 1) to (0, 0).
  example<Row>({{{{0, 0}, {10, 1}, {0, 1}}}, {1, 0.1}}, inside, "rounding");
  example<Row>({{{{0, 0}, {huge, 0}, {huge, huge}}}, {huge / 2, huge / 4}}, inside, "rounding");  // infinity - infinity
  example<Row>({{{{0, 0}, {3 * tiny, 0}, {0, 3 * tiny}}}, {tiny, tiny}}, inside, "rounding");     // every product is 0
  example<Row>({{{{0, 0}, {3 * tiny, 0}, {0, 3 * tiny}}}, {2 * tiny, 2 * tiny}}, outside, "rounding");
  example<Row>({{{{-0.0, 0.0}, {2, -0.0}, {0.0, 2}}}, {-0.0, 1}}, boundary);
}

TEST_CASE("point_in_convex_polygon: what is not convex is refused by its first vertex that is at defect") {
  const std::string flat = "convex: vertices on one line have no inside",
                    reflex = "convex: the ring must not turn against its direction";
  refused<Row>({{{{0, 0}, {1, 1}, {2, 2}}}, {0, 0}}, "polygon", flat);
  refused<Row>({{{{0, 0}, {3, 3}, {1, 1}, {2, 2}}}, {0, 0}}, "polygon", flat);
  refused<Row>({{{{0, 0}, {4, 0}, {4, 0}, {0, 4}}}, {0, 0}}, "polygon[1]",
               "different from vertex 2: drop one of the two");
  refused<Row>({{{{0, 0}, {4, 0}, {0, 4}, {0, 0}, {0, 0}}}, {0, 0}}, "polygon[3]",
               "different from vertex 0: drop one of the two");
  refused<Row>({{{{0, 0}, {2, 2}, {1, 1}, {1, 1}}}, {0, 0}}, "polygon[2]",
               "different from vertex 3: drop one of the two");
  refused<Row>({{{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}, {0, 0}}, "polygon[2]", reflex);
  refused<Row>({{{{0, 4}, {1, 1}, {4, 0}, {0, 0}}}, {0, 0}}, "polygon[1]", reflex);
  refused<Row>({{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}, {0, 0}}, "polygon[0]", "simple: its edge must not meet edge 2");
  // Twice round a triangle: every turn is to the left.
  refused<Row>({{{{0, 0}, {4, 0}, {0, 4}, {0, 0}, {4, 0}, {0, 4}}}, {0, 0}}, "polygon[0]",
               "simple: its edge must not meet edge 2");
}

CONTRACT("point_in_convex_polygon: the formula in double is right where the bound of its contract says so", ring, p) {
  return !certain(ring, p) || answer == truth.answer;
}

TEST_CASE("point_in_convex_polygon: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::point_in_convex_polygon_tests
