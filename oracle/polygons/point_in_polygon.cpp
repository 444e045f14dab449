// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/point_in_polygon.h"

#include <optional>
#include <stdexcept>

#include "geometry/validation.h"
#include "oracle/exact/systems/common_points.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {
namespace {

using Ring = Polygon2<Integer>;

Vector2<Integer> place(const Point2<Integer>& p) { return {p.x, p.y}; }

/// The polygon in integers relative to the point: the point is the origin.
struct Around {
  Ring ring;
  Rational unit;
};

template <class Number>
Around validated_point_in_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point) {
  validation::validate_all("polygon", polygon, "point", point);
  Polygon2<Number> all = polygon;
  all.vertices.push_back(point);
  IntegerRing integers(all);
  const Point2<Integer> origin = integers.ring.vertices.back();
  integers.ring.vertices.pop_back();
  for (Point2<Integer>& p : integers.ring.vertices) p = {Integer(p.x - origin.x), Integer(p.y - origin.y)};
  return {std::move(integers.ring), std::move(integers.unit)};
}

/// The first edge that contains the origin.
std::optional<std::size_t> edge_through_origin(const Ring& ring) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2<Integer> a = place(ring[i]), b = place(ring.next(i));
    if (sgn(cross(a, b)) == 0 && sgn(dot(a, b)) <= 0) return i;
  }
  return std::nullopt;
}

/// A ray from the origin that misses every vertex, backwards too; and the side of it on which each vertex lies.
struct Ray {
  Vector2<Integer> direction;
  std::vector<Integer> sides;
};

/// The first of (1, 1), (1, 2), (1, 3) ... that misses, or a quarter turn from these: each vertex rules out one at
/// most.
Ray missing_ray(const Ring& ring, bool quarter_turn) {
  for (std::int64_t slope = 1;; ++slope) {
    Ray ray{quarter_turn ? Vector2<Integer>{-slope, 1} : Vector2<Integer>{1, slope}, {}};
    for (const Point2<Integer>& vertex : ring.vertices) {
      ray.sides.push_back(cross(ray.direction, place(vertex)));
      if (sgn(ray.sides.back()) == 0) break;
    }
    if (sgn(ray.sides.back()) != 0) return ray;
  }
}

/// The crossing of a ray and an edge that has one end on either side of its line: at t direction.
struct Crossing {
  std::size_t edge;
  Fraction<Integer> t;
};

std::vector<Crossing> crossings(const Ring& ring, const Ray& ray) {
  std::vector<Crossing> found;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Integer &a = ray.sides[i], &b = ray.sides[i + 1 == ring.size() ? 0 : i + 1];
    if (sgn(a) == sgn(b)) continue;
    const Fraction<Integer> t{cross(place(ring[i]), place(ring.next(i))), Integer(b - a)};
    if (sgn(t.numerator) == sgn(t.denominator)) found.push_back({i, t});
  }
  return found;
}

Certificate on_edge(std::size_t edge, const Segment2<Integer>& ends) {
  const Vector2<Integer> v = ends.b - ends.a;
  const Integer length = dot(v, v), along = -dot(place(ends.a), v);
  const Rational t = sgn(length) == 0 ? Rational(0) : quotient(along, length);
  return {"on_edge", {{"edge", {Rational(edge)}}, {"t", {t}}}};
}

Certificate certificate_point_in_polygon(const std::vector<Crossing>& crossings, const Vector2<Integer>& along,
                                         const Rational& unit) {
  std::vector<Rational> edges, parameters;
  for (const Crossing& crossing : crossings) {
    edges.emplace_back(crossing.edge);
    parameters.push_back(rational(crossing.t));
  }
  const std::vector<Rational> direction{Rational(along.x * unit), Rational(along.y * unit)};
  return {"crossings", {{"direction", direction}, {"edges", edges}, {"t", parameters}}};
}

Rational least_squared_distance(const Ring& ring) {
  std::optional<Rational> least;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const auto found = squared_distance<Integer>({0, 0}, {ring[i], ring.next(i)}, Extent::segment);
    Rational distance = quotient(found.numerator, found.denominator);
    if (!least || distance < *least) least = std::move(distance);
  }
  return *least;
}

template <class Number>
Truth<Location> truth_of_point_in_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point) {
  const auto [ring, unit] = validated_point_in_polygon(polygon, point);
  if (const auto i = edge_through_origin(ring))
    return {Location::boundary, Rational(0),
            [i = *i, ends = Segment2<Integer>{ring[*i], ring.next(*i)}] { return on_edge(i, ends); }};
  Ray ray = missing_ray(ring, false);
  std::vector<Crossing> crossed = crossings(ring, ray);
  const bool inside = crossed.size() % 2 == 1;
  if ((crossings(ring, missing_ray(ring, true)).size() % 2 == 1) != inside)
    throw std::logic_error("point_in_polygon: two rays disagree");
  return {inside ? Location::inside : Location::outside, Rational(least_squared_distance(ring) * unit * unit),
          [crossed = std::move(crossed), along = std::move(ray.direction), unit = unit] {
            return certificate_point_in_polygon(crossed, along, unit);
          }};
}

}  // namespace

template <Exact Number>
Truth<Location> point_in_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point) {
  return truth_of_point_in_polygon(polygon, point);
}
template Truth<Location> point_in_polygon(const Polygon2d&, const Point2d&);
template Truth<Location> point_in_polygon(const Polygon2<Rational>&, const Point2<Rational>&);

Location point_in_polygon_location(const Polygon2d& polygon, const Point2d& point) {
  return location_by_winding<Integer>(validated_point_in_polygon(polygon, point).ring);
}

}  // namespace touchstone::oracle
