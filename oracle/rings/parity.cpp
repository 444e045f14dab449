// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/parity.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "oracle/exact/systems/common_points.h"

namespace touchstone::oracle {
namespace {

using Ring = Polygon2<Integer>;
using Rings = std::vector<Ring>;

Vector2<Integer> place(const Point2<Integer>& p) { return {p.x, p.y}; }

/// An edge by its place among those of all rings, one ring after the other.
struct Numbered {
  std::size_t number;
  Segment2<Integer> ends;
};

/// The first edge that contains the origin.
std::optional<Numbered> edge_through_origin(const Rings& rings) {
  std::size_t number = 0;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i, ++number) {
      const Vector2<Integer> a = place(ring[i]), b = place(ring.next(i));
      if (sgn(cross(a, b)) == 0 && sgn(dot(a, b)) <= 0) return Numbered{number, {ring[i], ring.next(i)}};
    }
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
Ray missing_ray(const Rings& rings, bool quarter_turn) {
  const auto misses = [&rings](Ray& ray) {
    for (const Ring& ring : rings) {
      for (const Point2<Integer>& vertex : ring.vertices) {
        ray.sides.push_back(cross(ray.direction, place(vertex)));
        if (sgn(ray.sides.back()) == 0) return false;
      }
    }
    return true;
  };
  for (std::int64_t slope = 1;; ++slope) {
    Ray ray{quarter_turn ? Vector2<Integer>{-slope, 1} : Vector2<Integer>{1, slope}, {}};
    if (misses(ray)) return ray;
  }
}

/// The crossing of a ray and an edge that has one end on either side of its line: at t direction.
struct Crossing {
  std::size_t edge;
  Fraction<Integer> t;
};

std::vector<Crossing> crossings(const Rings& rings, const Ray& ray) {
  std::vector<Crossing> found;
  std::size_t first = 0;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Integer &a = ray.sides[first + i], &b = ray.sides[i + 1 == ring.size() ? first : first + i + 1];
      if (sgn(a) == sgn(b)) continue;
      const Fraction<Integer> t{cross(place(ring[i]), place(ring.next(i))), Integer(b - a)};
      if (sgn(t.numerator) == sgn(t.denominator)) found.push_back({first + i, t});
    }
    first += ring.size();
  }
  return found;
}

Certificate on_edge(std::size_t edge, const Segment2<Integer>& ends) {
  const Vector2<Integer> v = ends.b - ends.a;
  const Integer length = dot(v, v), along = -dot(place(ends.a), v);
  const Rational t = sgn(length) == 0 ? Rational(0) : quotient(along, length);
  return {"on_edge", {{"edge", {Rational(edge)}}, {"t", {t}}}};
}

Certificate certificate_of_crossings(const std::vector<Crossing>& crossings, const Vector2<Integer>& along,
                                         const Rational& unit) {
  std::vector<Rational> edges, parameters;
  for (const Crossing& crossing : crossings) {
    edges.emplace_back(crossing.edge);
    parameters.push_back(rational(crossing.t));
  }
  const std::vector<Rational> direction{Rational(along.x * unit), Rational(along.y * unit)};
  return {"crossings", {{"direction", direction}, {"edges", edges}, {"t", parameters}}};
}

Rational least_squared_distance(const Rings& rings) {
  std::optional<Rational> least;
  for (const Ring& ring : rings) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto found = squared_distance<Integer>({0, 0}, {ring[i], ring.next(i)}, Extent::segment);
      Rational distance = quotient(found.numerator, found.denominator);
      if (!least || distance < *least) least = std::move(distance);
    }
  }
  return *least;
}

}  // namespace

Truth<Location> location_by_parity(const Rings& rings, const Rational& unit) {
  if (const auto edge = edge_through_origin(rings))
    return {Location::boundary, Rational(0), [edge = *edge] { return on_edge(edge.number, edge.ends); }};
  Ray ray = missing_ray(rings, false);
  std::vector<Crossing> crossed = crossings(rings, ray);
  const bool inside = crossed.size() % 2 == 1;
  if ((crossings(rings, missing_ray(rings, true)).size() % 2 == 1) != inside)
    throw std::logic_error("location_by_parity: two rays disagree");
  return {inside ? Location::inside : Location::outside, Rational(least_squared_distance(rings) * unit * unit),
          [crossed = std::move(crossed), along = std::move(ray.direction), unit] {
            return certificate_of_crossings(crossed, along, unit);
          }};
}

}  // namespace touchstone::oracle
