// SPDX-License-Identifier: Apache-2.0
#include "oracle/exact/moving/ball_near_polygon.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/exact/numbers/parabola.h"

namespace touchstone::oracle {
namespace {

using Vector = Vector3<Rational>;

/// A height of the center: of a plane, in units of the length of its normal.
struct HeightInTime {
  Rational start, rise;
  int sign(const Surd& t) const { return sgn(Surd(start) + t * Surd(rise)); }
};

struct Polygon : BallNearPolygon {
  std::size_t size() const { return corners.size(); }
  Vector edge(std::size_t k) const { return corners[(k + 1) % size()] - corners[k]; }
  Vector way(std::size_t k) const { return center - corners[k]; }
  Vector normal() const { return cross(edge(0), edge(1)); }
  HeightInTime height(const Vector& along, std::size_t corner) const {
    return {dot(along, way(corner)), dot(along, velocity)};
  }
};

/// A corner, an edge or the face.
struct Part {
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
std::vector<Part> parts_of(const Polygon& q) {
  const Rational squared_radius(q.radius * q.radius);
  const Vector n = q.normal(), &v = q.velocity;
  std::vector<Part> parts;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const Vector w = q.way(k);
    parts.push_back({{k}, Rational(dot(w, w) - squared_radius), dot(w, v), dot(v, v), 1, {}});
  }
  std::vector<HeightInTime> inside;
  for (std::size_t k = 0; k < q.size(); ++k) {
    const std::size_t next = (k + 1) % q.size();
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
  std::vector<std::size_t> all(q.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  parts.push_back({std::move(all), Rational(h.start * h.start - squared_radius * dot(n, n)), Rational(h.start * h.rise),
                   Rational(h.rise * h.rise), dot(n, n), std::move(inside)});
  return parts;
}

/// The part that is met first, and when.
struct Entry {
  Part part;
  Surd t;
};
std::optional<Entry> first_entry(const std::vector<Part>& parts) {
  std::optional<Entry> first;
  for (const Part& part : parts) {
    const FirstContact<Surd> entry = part.parabola().contact();
    if (entry.t && !(first && first->t <= *entry.t) && part.over(*entry.t)) first = {part, *entry.t};
  }
  return first;
}

/// A normal along which no corner is lower than x, and the velocity leads up: x less a part of the velocity is not in
/// the polygon. x is in the part that is met, at the rational time of a double zero; there the velocity leads out of
/// the plane; or in it, into the polygon over an edge; or, for a segment, across it or from an end of it.
Vector way_in(const Polygon& q, const Point3<Rational>& x) {
  const Vector n = q.normal(), &v = q.velocity;
  std::vector<Vector> tried{n, Rational(-1) * n, v};
  for (std::size_t k = 0; k < q.size(); ++k) {
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

Certificate certificate_of_entry(const Polygon& q, const std::optional<Entry>& entry) {
  const auto nearest_at = [&q](const Rational& t) { return nearest_pair({q.center + t * q.velocity}, q.corners); };
  if (!entry) {
    const NearestPair pair = nearest_pair({q.center, q.center + q.velocity}, q.corners);
    return {"separating_axis", {{"normal", numbers(pair.on_a - pair.on_b)}}};
  }
  if (sgn(entry->t) == 0) return {"start", {{"weights", nearest_at(0).weights_of_b}}};
  std::vector<Rational> corners;
  for (const std::size_t k : entry->part.corners) corners.emplace_back(static_cast<std::int64_t>(k));
  const bool touches = sgn(entry->part.parabola().discriminant()) == 0;
  const Vector m = touches ? way_in(q, nearest_at(entry->t.rational_part()).on_b) : Vector{0, 0, 0};
  return {"first_contact", {{"corners", std::move(corners)}, {"normal", numbers(m)}}};
}

/// How far a path that crosses the polygon has to be moved until it does not, squared: along a normal of a face of the
/// solid that their differences make. 0 where that is flat.
Rational squared_depth(const Polygon& q) {
  std::vector<Vector> normals{q.normal()};
  for (std::size_t k = 0; k < q.size(); ++k) normals.push_back(cross(q.edge(k), q.velocity));
  std::optional<Rational> least;
  for (const Vector& n : normals) {
    if (zero(n)) continue;
    std::vector<Rational> heights(q.size());
    for (std::size_t k = 0; k < q.size(); ++k) heights[k] = dot(n, q.way(k));
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const Rational rise = dot(n, q.velocity), none(0);
    const Rational below(*low + std::min(none, rise)), above(*high + std::max(none, rise));
    const Rational way(std::min(abs(below), abs(above))), square(way * way / dot(n, n));
    if (!least || square < *least) least = square;
  }
  return least.value_or(Rational(0));
}

}  // namespace

Truth<FirstContact<Surd>> first_contact(BallNearPolygon ball) {
  Polygon q{std::move(ball)};
  const std::vector<Part> parts = parts_of(q);
  std::optional<Entry> entry = first_entry(parts);
  FirstContact<Surd> first{HitRelation::never, std::nullopt};
  if (entry) first = {HitRelation::hit, entry->t};
  Rational least = *parts[0].least();
  for (const Part& part : parts)
    if (const std::optional<Rational> found = part.least()) least = std::min(least, *found);
  Rational margin(abs(least));
  if (least + q.radius * q.radius == 0) margin += squared_depth(q);
  return {std::move(first), std::move(margin),
          [q = std::move(q), entry = std::move(entry)] { return certificate_of_entry(q, entry); }};
}

}  // namespace touchstone::oracle
