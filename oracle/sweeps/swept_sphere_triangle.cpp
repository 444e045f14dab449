// SPDX-License-Identifier: Apache-2.0
#include "oracle/sweeps/swept_sphere_triangle.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "oracle/exact/numbers/parabola.h"
#include "oracle/exact/shapes/nearest_pair.h"

namespace touchstone::oracle {
namespace {

using Vector = Vector3<Rational>;

/// A height of the center: of a plane, in units of the length of its normal.
struct HeightInTime {
  Rational start, rise;
  int sign(const Surd& t) const { return sgn(Surd(start) + t * Surd(rise)); }
};

struct BallNearTriangle {
  std::array<Point3<Rational>, 3> corners;
  Point3<Rational> center;
  Vector velocity;
  Rational radius;

  Vector edge(std::size_t k) const { return corners[(k + 1) % 3] - corners[k]; }
  Vector way(std::size_t k) const { return center - corners[k]; }
  Vector normal() const { return cross(edge(0), edge(1)); }
  HeightInTime height(const Vector& along, std::size_t corner) const {
    return {dot(along, way(corner)), dot(along, velocity)};
  }
  Hull triangle() const { return {corners[0], corners[1], corners[2]}; }
};

/// A corner, an edge or the face.
struct PartOfTriangle {
  std::vector<std::size_t> corners;
  Rational start, half, square, scale;  ///< square t^2 + 2 half t + start, over scale: the squared distance less r^2
  std::vector<HeightInTime> sides;      ///< the center is over it where none is negative

  bool over(const Surd& t) const {
    return std::all_of(sides.begin(), sides.end(), [&t](const HeightInTime& side) { return side.sign(t) >= 0; });
  }
  /// Times a common denominator, which moves no zero.
  Parabola parabola() const {
    Integer common(1);
    for (const Rational* coefficient : {&start, &half, &square})
      mpz_lcm(common.get_mpz_t(), common.get_mpz_t(), coefficient->get_den_mpz_t());
    const auto integer = [&common](const Rational& c) { return Integer(c.get_num() * (common / c.get_den())); };
    return {integer(start), integer(half), integer(square)};
  }
  /// The least squared distance less r^2 at the start, at the end and at its vertex, of those that are over it.
  std::optional<Rational> least() const {
    std::vector<Rational> times{0, 1};
    if (sgn(half) < 0 && -half < square) times.emplace_back(-half / square);
    std::optional<Rational> found;
    for (const Rational& t : times) {
      const Rational value((start + t * (2 * half + t * square)) / scale);
      if (over(t) && (!found || value < *found)) found = value;
    }
    return found;
  }
};

/// The smallest first: what is met within an edge is not said to be of the face.
std::vector<PartOfTriangle> parts_of(const BallNearTriangle& q) {
  const Rational squared_radius(q.radius * q.radius);
  const Vector n = q.normal(), &v = q.velocity;
  std::vector<PartOfTriangle> parts;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector w = q.way(k);
    parts.push_back({{k}, Rational(dot(w, w) - squared_radius), dot(w, v), dot(v, v), 1, {}});
  }
  std::vector<HeightInTime> inside;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const Vector e = q.edge(k), w = cross(q.way(k), e), rise = cross(v, e);
    inside.push_back(q.height(cross(n, e), k));
    if (zero(e)) continue;
    parts.push_back({{std::min(k, next), std::max(k, next)},
                     Rational(dot(w, w) - squared_radius * dot(e, e)),
                     dot(w, rise),
                     dot(rise, rise),
                     dot(e, e),
                     {q.height(e, k), q.height(Rational(-1) * e, next)}});
  }
  if (zero(n)) return parts;
  const HeightInTime h = q.height(n, 0);
  parts.push_back({{0, 1, 2},
                   Rational(h.start * h.start - squared_radius * dot(n, n)),
                   Rational(h.start * h.rise),
                   Rational(h.rise * h.rise),
                   dot(n, n),
                   std::move(inside)});
  return parts;
}

/// The part that is met first, and when.
struct Entry {
  PartOfTriangle part;
  Surd t;
};
std::optional<Entry> first_entry(const std::vector<PartOfTriangle>& parts) {
  std::optional<Entry> first;
  for (const PartOfTriangle& part : parts) {
    const FirstContact<Surd> entry = part.parabola().contact();
    if (entry.t && !(first && first->t <= *entry.t) && part.over(*entry.t)) first = {part, *entry.t};
  }
  return first;
}

/// A normal along which no corner is lower than x, and the velocity leads up: x less a part of the velocity is not in
/// the triangle. x is in the part that is met, at the rational time of a double zero; there the velocity leads out of
/// the plane; or in it, into the triangle over an edge; or, for a segment, across it or from an end of it.
Vector way_in(const BallNearTriangle& q, const Point3<Rational>& x) {
  const Vector n = q.normal(), &v = q.velocity;
  std::vector<Vector> tried{n, Rational(-1) * n, v};
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector e = q.edge(k);
    for (const Vector& each : {cross(n, e), e, Rational(-1) * e, dot(e, e) * v - dot(e, v) * e}) tried.push_back(each);
  }
  for (const Vector& m : tried) {
    const auto not_below = [&](const Point3<Rational>& corner) { return sgn(dot(m, corner - x)) >= 0; };
    if (sgn(dot(m, v)) > 0 && std::all_of(q.corners.begin(), q.corners.end(), not_below)) return m;
  }
  return {0, 0, 0};
}

std::vector<Rational> numbers(const Vector& v) { return {v.x, v.y, v.z}; }

Certificate certificate_of_entry(const BallNearTriangle& q, const std::optional<Entry>& entry) {
  const auto nearest_at = [&q](const Rational& t) { return nearest_pair({q.center + t * q.velocity}, q.triangle()); };
  if (!entry) {
    const NearestPair pair = nearest_pair({q.center, q.center + q.velocity}, q.triangle());
    return {"separating_axis", {{"normal", numbers(pair.on_a - pair.on_b)}}};
  }
  if (sgn(entry->t) == 0) return {"start", {{"weights", nearest_at(0).weights_of_b}}};
  std::vector<Rational> corners;
  for (const std::size_t k : entry->part.corners) corners.emplace_back(static_cast<std::int64_t>(k));
  const bool touches = sgn(entry->part.parabola().discriminant()) == 0;
  const Vector m = touches ? way_in(q, nearest_at(entry->t.rational_part()).on_b) : Vector{0, 0, 0};
  return {"first_contact", {{"corners", std::move(corners)}, {"normal", numbers(m)}}};
}

/// How far a path that crosses the triangle has to be moved until it does not, squared: along a normal of a face of the
/// solid that their differences make. 0 where that is flat.
Rational squared_depth(const BallNearTriangle& q) {
  std::vector<Vector> normals{q.normal()};
  for (std::size_t k = 0; k < 3; ++k) normals.push_back(cross(q.edge(k), q.velocity));
  std::optional<Rational> least;
  for (const Vector& n : normals) {
    if (zero(n)) continue;
    std::array<Rational, 3> heights;
    for (std::size_t k = 0; k < 3; ++k) heights[k] = dot(n, q.way(k));
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const Rational rise = dot(n, q.velocity), none(0);
    const Rational below(*low + std::min(none, rise)), above(*high + std::max(none, rise));
    const Rational way(std::min(abs(below), abs(above))), square(way * way / dot(n, n));
    if (!least || square < *least) least = square;
  }
  return least.value_or(Rational(0));
}

template <class Number>
Truth<FirstContact<Surd>> truth_swept_sphere_triangle(const Sphere3<Number>& sphere, const Vector3<Number>& v,
                                                      const Triangle3<Number>& triangle) {
  validation::validate_all("sphere", sphere, "velocity", v, "triangle", triangle);
  const auto& [a, b, c] = triangle;
  BallNearTriangle q{
      {exact(a), exact(b), exact(c)}, exact(sphere.center), {exact(v.x), exact(v.y), exact(v.z)}, exact(sphere.radius)};
  const std::vector<PartOfTriangle> parts = parts_of(q);
  std::optional<Entry> entry = first_entry(parts);
  FirstContact<Surd> first{HitRelation::never, std::nullopt};
  if (entry) first = {HitRelation::hit, entry->t};
  Rational least = *parts[0].least();
  for (const PartOfTriangle& part : parts)
    if (const std::optional<Rational> found = part.least()) least = std::min(least, *found);
  Rational margin(abs(least));
  if (least + q.radius * q.radius == 0) margin += squared_depth(q);
  return {std::move(first), std::move(margin),
          [q = std::move(q), entry = std::move(entry)] { return certificate_of_entry(q, entry); }};
}

}  // namespace

template <Exact Number>
Truth<FirstContact<Surd>> swept_sphere_triangle(const Sphere3<Number>& sphere, const Vector3<Number>& velocity,
                                                const Triangle3<Number>& triangle) {
  return truth_swept_sphere_triangle(sphere, velocity, triangle);
}
template Truth<FirstContact<Surd>> swept_sphere_triangle(const Sphere3d&, const Vector3d&, const Triangle3d&);
template Truth<FirstContact<Surd>> swept_sphere_triangle(const Sphere3<Rational>&, const Vector3<Rational>&,
                                                         const Triangle3<Rational>&);

}  // namespace touchstone::oracle
