// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/point_in_convex_polygon.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/systems/common_points.h"
#include "oracle/rings/simple.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {
namespace {

/// The ring, with the point as one more vertex after the last.
struct IntegerInput {
  Polygon2<Integer> ring;
  Point2<Integer> point;
  Rational unit;
};

/// Refuses rings that are not convex: accepts a simple polygon of some area without a turn against the sign of its
/// area.
void validate_convex(const IntegerRing& ring) {
  const auto defect = ring_defect(ring);
  if (defect && defect->first == defect->second) validation::refuse("polygon", *defect, ring.size());
  bool turns = false;
  for (Index i = 0; i < ring.size(); ++i) turns = turns || ring.turn_at(i) != 0;  // neighbours differ
  if (!turns) validation::refuse_flat("polygon");
  if (defect) validation::refuse("polygon", *defect, ring.size());
  const int winding = sgn(ring.area());
  for (Index i = 0; i < ring.size(); ++i) {
    if (ring.turn_at(i) * winding < 0) validation::refuse_reflex("polygon", i);
  }
}

template <class Number>
IntegerInput validated_point_in_convex_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point) {
  validation::validate_all("polygon", polygon, "point", point);
  Polygon2<Number> all = *validation::OpenRing(polygon);
  validate_convex(IntegerRing(all));
  all.vertices.push_back(point);
  IntegerRing integers(all);
  const Point2<Integer> p = integers.ring.vertices.back();
  integers.ring.vertices.pop_back();
  return {std::move(integers.ring), p, std::move(integers.unit)};
}

/// A triangle (0, i, i + 1) of some area, and the point's weights in it times twice that area: the areas of the
/// triangles that the point makes with its edges, positive on the inside.
struct Triangle {
  std::size_t i;
  std::array<Integer, 3> areas;
  bool holds() const { return sgn(areas[0]) >= 0 && sgn(areas[1]) >= 0 && sgn(areas[2]) >= 0; }
};

std::vector<Triangle> fan(const IntegerInput& w) {
  std::vector<Triangle> made;
  for (std::size_t i = 1; i + 1 < w.ring.size(); ++i) {
    const Point2<Integer>&a = w.ring[0], &b = w.ring[i], &c = w.ring[i + 1];
    const int side = sgn(IntegerRing::area(a, b, c));
    if (side == 0) continue;  // flat vertices next to vertex 0
    const auto area = [&](const Point2<Integer>& q, const Point2<Integer>& r) {
      return Integer(side * IntegerRing::area(q, r, w.point));
    };
    made.push_back({i, {area(b, c), area(c, a), area(a, b)}});
  }
  return made;
}

struct Found {
  Location location;
  std::optional<Triangle> triangle;
};

/// A triangle's side opposite vertex 0 is an edge of the polygon; the two sides at vertex 0 are diagonals, except for
/// the first side of the first triangle and the last of the last.
Found located(const IntegerInput& w) {
  const std::vector<Triangle> triangles = fan(w);
  for (const Triangle& t : triangles) {
    if (!t.holds()) continue;
    const bool first = t.i == triangles.front().i, last = t.i == triangles.back().i;
    const bool on = sgn(t.areas[0]) == 0 || (last && sgn(t.areas[1]) == 0) || (first && sgn(t.areas[2]) == 0);
    // On a diagonal the point is inside, unless it is an end of it.
    const bool at_vertex_0 = sgn(t.areas[1]) == 0 && sgn(t.areas[2]) == 0;
    return {on || at_vertex_0 ? Location::boundary : Location::inside, t};
  }
  return {Location::outside, std::nullopt};
}

Certificate certificate_point_in_convex_polygon(const IntegerInput& w, const std::optional<Triangle>& triangle) {
  if (triangle) {
    const auto& [a, b, c] = triangle->areas;
    const Integer sum = a + b + c;
    const std::vector<Rational> corners{Rational(0), Rational(triangle->i), Rational(triangle->i + 1)};
    return {"barycentric", {{"corners", corners}, {"weights", {quotient(a, sum), quotient(b, sum), quotient(c, sum)}}}};
  }
  for (std::size_t i = 0;; ++i) {
    const Point2<Integer>&a = w.ring[i], &b = w.ring.next(i);
    const int side = sgn(IntegerRing::area(a, b, w.point));
    const auto apart = [&](const Point2<Integer>& v) { return sgn(IntegerRing::area(a, b, v)) * side <= 0; };
    if (side != 0 && std::all_of(w.ring.vertices.begin(), w.ring.vertices.end(), apart))
      return {"separating_edge", {{"edge", {Rational(i)}}}};
  }
}

/// The least distance in squared units.
Rational least_distance(const IntegerInput& w) {
  std::optional<Rational> least;
  for (std::size_t i = 0; i < w.ring.size(); ++i) {
    const auto found = squared_distance<Integer>(w.point, {w.ring[i], w.ring.next(i)}, Extent::segment);
    Rational distance = quotient(found.numerator, found.denominator);
    if (!least || distance < *least) least = std::move(distance);
  }
  return *least;
}

template <class Number>
Truth<Location> truth_of_point_in_convex_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point) {
  IntegerInput w = validated_point_in_convex_polygon(polygon, point);
  Found found = located(w);
  const Rational margin(found.location == Location::boundary ? Rational(0) : least_distance(w) * w.unit * w.unit);
  return {found.location, margin, [w = std::move(w), triangle = std::move(found.triangle)] {
            return certificate_point_in_convex_polygon(w, triangle);
          }};
}

}  // namespace

template <Exact Number>
Truth<Location> point_in_convex_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point) {
  return truth_of_point_in_convex_polygon(polygon, point);
}
template Truth<Location> point_in_convex_polygon(const Polygon2d&, const Point2d&);
template Truth<Location> point_in_convex_polygon(const Polygon2<Rational>&, const Point2<Rational>&);

}  // namespace touchstone::oracle
