// SPDX-License-Identifier: Apache-2.0
#include "catalogue/rows/polygons/point_in_polygon.h"

#include "proptests/closed_rings.h"
#include "proptests/forward_error.h"
#include "robust/lines/orientation.h"
#include "robust/lines/point_on_segment.h"

namespace touchstone::proptests::point_in_polygon_tests {
namespace {

using Row = rows::point_in_polygon;

constexpr Location inside = Location::inside, boundary = Location::boundary, outside = Location::outside;

bool on(const Point2d& p, const Point2d& a, const Point2d& b) {
  return robust::point_on_segment_relation(p, {a, b}) == Incidence::on;
}

bool on_an_edge(const Polygon2d& ring, const Point2d& p) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    if (on(p, ring[i], ring.next(i))) return true;
  }
  return false;
}

/// Vertices first to last, round the ring.
Polygon2d part(const Polygon2d& ring, std::size_t first, std::size_t last) {
  Polygon2d found;
  for (std::size_t i = first; i != last; i = (i + 1) % ring.size()) found.vertices.push_back(ring[i]);
  found.vertices.push_back(ring[last]);
  return found;
}

/// The greatest error bound E of the contract; empty where a difference overflows.
std::optional<Rational> greatest_error(const Polygon2d& ring, const Point2d& p) {
  const Rational u = unit();
  Rational greatest = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point2d &a = ring[i], &b = ring.next(i);
    if ((a.y > p.y) == (b.y > p.y)) continue;
    const double t = (p.y - a.y) / (b.y - a.y), d = b.x - a.x, q = t * d, x = a.x + q;
    if (!finite(p.y - a.y, b.y - a.y, d, x)) return std::nullopt;
    const Rational e = (3 + 5 * u) * u * size(t) + power_of_two(-1074);
    const Rational bound = e * size(d) + (size(t) + e) * u * size(d) + u * (size(q) + size(x)) + power_of_two(-1075);
    greatest = std::max(greatest, bound);
  }
  return greatest;
}

const Polygon2d square{{{0, 0}, {4, 0}, {4, 4}, {0, 4}}};
const Polygon2d bow_tie{{{-2, -2}, {2, 2}, {2, -2}, {-2, 2}}};
/// Each point of the core is surrounded twice.
const Polygon2d pentagram{{{0, 6}, {4, -5}, {-6, 2}, {6, 2}, {-4, -5}}};

}  // namespace

LAW("point_in_polygon: it does not matter where the ring starts, nor in which direction it goes", ring, p) {
  if (ring.size() == 3 && repeats(ring)) return true;
  const Location location = ask(asked);
  Polygon2d other = ring;
  std::reverse(other.vertices.begin(), other.vertices.end());
  if (ask(Row::Question{other, p}) != location) return false;
  for (std::size_t turns = 0; turns < 3; ++turns) {
    std::rotate(other.vertices.begin(), other.vertices.begin() + 1, other.vertices.end());
    if (ask(Row::Question{other, p}) != location) return false;
  }
  return true;
}

ROBUST_LAW("point_in_polygon: the boundary is the union of the edges", ring, p) {
  return (ask(asked) == boundary) == on_an_edge(ring, p);
}

LAW("point_in_polygon: vertices are on the boundary", ring) {
  for (const std::size_t i : {std::size_t{0}, ring.size() / 2, ring.size() - 1}) {
    if (ask(Row::Question{ring, ring[i]}) != boundary) return false;
  }
  return true;
}

LAW("point_in_polygon: a repeated vertex changes nothing, a spike only where it lies", ring, p) {
  const Location location = ask(asked);
  const std::size_t i = ring.size() / 2;
  const Point2d vertex = ring[i], tip = ring[0];
  Polygon2d longer = ring;
  const auto behind = longer.vertices.begin() + static_cast<std::ptrdiff_t>(i + 1);
  longer.vertices.insert(behind, vertex);
  if (ask(Row::Question{longer, p}) != location) return false;
  longer.vertices.insert(longer.vertices.begin() + static_cast<std::ptrdiff_t>(i + 1), tip);
  return ask(Row::Question{longer, p}) == (on(p, vertex, tip) ? boundary : location);
}

LAW("point_in_polygon: cut along a diagonal, a point is inside exactly one part or none", ring, p) {
  const std::size_t n = ring.size(), k = n / 2;
  if (n < 4 || ring[0] == ring[k] || on(p, ring[0], ring[k])) return true;
  const Location whole = ask(asked), one = ask(Row::Question{part(ring, 0, k), p}),
                 other = ask(Row::Question{part(ring, k, 0), p});
  if (one == boundary || other == boundary) return whole == boundary;
  return whole == ((one == inside) != (other == inside) ? inside : outside);
}

ROBUST_LAW("point_in_polygon: inside a triangle a point is on one side of all three edges", ring, p) {
  if (ring[0] == ring[2]) return true;
  const Polygon2d triangle{{ring[0], ring[1], ring[2]}};
  const Side first = robust::orientation(ring[0], ring[1], p);
  const bool all = first != Side::on && robust::orientation(ring[1], ring[2], p) == first &&
                   robust::orientation(ring[2], ring[0], p) == first;
  return (ask(Row::Question{triangle, p}) == inside) == all;
}

TEST_CASE("point_in_polygon: p. 14's ray test worked by hand") {
  example<Row>({square, {1, 3}}, inside);    // crosses x = 4
  example<Row>({square, {-1, 3}}, outside);  // crosses x = 0 and x = 4
  example<Row>({square, {5, 3}}, outside);   // crosses nothing
  example<Row>({square, {1, 5}}, outside);
  // A V open to the top: at height 3 its walls are at x = 0, 1.5, 2.5 and 4.
  const Polygon2d v{{{0, 0}, {4, 0}, {4, 4}, {3, 4}, {2, 2}, {1, 4}, {0, 4}}};
  example<Row>({v, {1, 3}}, inside);
  example<Row>({v, {2, 3}}, outside);
  example<Row>({v, {3, 3}}, inside);
  example<Row>({v, {1.5, 3}}, boundary);
}

TEST_CASE("point_in_polygon: p. 15's special cases worked by hand") {
  const Polygon2d diamond{{{0, -2}, {3, 0}, {0, 2}, {-3, 0}}};
  example<Row>({diamond, {0, 0}}, inside);    // the ray leaves through a vertex
  example<Row>({diamond, {-5, 0}}, outside);  // it passes two
  example<Row>({diamond, {-5, 2}}, outside);  // it touches the topmost vertex
  example<Row>({diamond, {-5, -2}}, outside);
  const Polygon2d stairs{{{0, 0}, {6, 0}, {6, 4}, {4, 4}, {4, 2}, {2, 2}, {2, 4}, {0, 4}}};
  example<Row>({stairs, {1, 2}}, inside);  // the ray runs along the edge from (4, 2) to (2, 2), and leaves
  example<Row>({stairs, {-1, 2}}, outside);
  example<Row>({stairs, {-1, 4}}, outside);  // along two edges
  example<Row>({stairs, {3, 4}}, outside);
  example<Row>({stairs, {-1, 0}}, outside);
  example<Row>({stairs, {3, 2}}, boundary);
  example<Row>({stairs, {1, 4}}, boundary);
  example<Row>({stairs, {4, 3}}, boundary);
  for (const Point2d& vertex : stairs.vertices) example<Row>({stairs, vertex}, boundary);
}

TEST_CASE("point_in_polygon: rings that cross themselves, by parity") {
  example<Row>({bow_tie, {1, 0}}, inside);
  example<Row>({bow_tie, {-1, 0.5}}, inside);
  example<Row>({bow_tie, {0, 1}}, outside);
  example<Row>({bow_tie, {0, 0}}, boundary);  // where it crosses itself
  example<Row>({pentagram, {0, 0}}, outside);
  example<Row>({pentagram, {0, 5}}, inside);
  example<Row>({pentagram, {5, 1.5}}, inside);
  example<Row>({pentagram, {0, 2}}, boundary);
  // Twice round the square: every place inside has an even number of crossings.
  example<Row>({{{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {4, 0}, {4, 4}, {0, 4}}}, {1, 2}}, outside);
}

TEST_CASE("point_in_polygon: rings without an inside, spikes and repeated vertices") {
  example<Row>({{{{0, 0}, {4, 2}, {2, 1}}}, {3, 1.5}}, boundary);
  example<Row>({{{{0, 0}, {4, 2}, {2, 1}}}, {3, 1}}, outside);
  example<Row>({{{{0, 0}, {4, 0}, {2, 0}}}, {-1, 0}}, outside);
  example<Row>({{{{0, 0}, {4, 0}, {2, 0}}}, {3, 0}}, boundary);
  example<Row>({{{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}, {1, 1}}, boundary);
  example<Row>({{{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}, {0, 1}}, outside);
  // A spike from (4, 2) to (8, 2) and back, and a corner written twice.
  const Polygon2d spiked{{{0, 0}, {4, 0}, {4, 2}, {8, 2}, {4, 2}, {4, 4}, {0, 4}, {0, 4}}};
  example<Row>({spiked, {1, 2}}, inside);
  example<Row>({spiked, {6, 2}}, boundary);
  example<Row>({spiked, {6, 3}}, outside);
  example<Row>({spiked, {-1, 4}}, outside);
}

TEST_CASE("point_in_polygon: rounding of a crossing's place") {
  // 0.1 as a double is 3602879701896397 / 2^55. The edge is at ten times that, 1 + 2^-54, which rounds to 1.
  example<Row>({{{{0, 0}, {10, 1}, {0, 1}}}, {1, 0.1}}, inside, "rounding");
  example<Row>({{{{0, 0}, {0.3, 0.3}, {0, 1}}}, {0.1, 0.1}}, boundary);
}

TEST_CASE("point_in_polygon: an edge from far away, the first of a part") {
  Polygon2d ring;
  for (int i = 0; i < 15; ++i) ring.vertices.push_back({3.0 * i, static_cast<double>(i % 2)});
  ring.vertices.insert(ring.vertices.end(), {{-0x1p29, 0x1p29}, {48, 0}, {18, -1000}});
  // 12 / 2^30 of the way from (48, 0) to (-2^29, 2^29), whose extent is (-2^29 - 48, 2^29): (48 - 6 - 576 / 2^30, 6).
  // The formula finds the crossing by a product of 58 bits.
  example<Row>({ring, {42 - 576 * 0x1p-30, 6}}, boundary, "rounding");
  example<Row>({ring, {42 - 577 * 0x1p-30, 6}}, inside);  // between that edge and the one from (42, 0)
  example<Row>({ring, {42 - 575 * 0x1p-30, 6}}, outside, "rounding");
}

TEST_CASE("point_in_polygon: a last position that repeats the first is no vertex more") {
  for (const Polygon2d& ring : {closed(square), closed(closed(square))}) {
    example<Row>({ring, {1, 3}}, inside);
    example<Row>({ring, {0, 0}}, boundary);
    example<Row>({ring, {0, 2}}, boundary);
    example<Row>({ring, {-1, 0}}, outside);  // level with the vertex
  }
  example<Row>({{{{0, 0}, {4, 0}, {0, 4}, {0, -0.0}}}, {1, 1}}, inside);
  example<Row>({{{{0, 0}, {2, 2}, {1, 1}, {0, 0}}}, {1.5, 1.5}}, boundary);
  // Long ones, and so far away that no lattice holds them.
  Polygon2d saw{{{0, -1e300}}};
  for (int i = 0; i < 40; ++i) saw.vertices.push_back({40.0 - i, 1.0 + i % 2});
  example<Row>({closed(saw), {20, 0.5}}, inside);
  example<Row>({closed(saw), {20, 3}}, outside);
}

CONTRACT("point_in_polygon: the formula in double is right beyond the margin of its contract", ring, p) {
  const auto error = greatest_error(ring, p);
  return !error || *truth.margin <= *error * *error || answer == truth.answer;
}

TEST_CASE("point_in_polygon: the formula is right in exact arithmetic") { right_in_exact_arithmetic<Row>(); }

}  // namespace touchstone::proptests::point_in_polygon_tests
