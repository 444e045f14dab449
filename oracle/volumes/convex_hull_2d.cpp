// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/convex_hull_2d.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/wide.h"
#include "oracle/exact/shapes/extreme_ring.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {
namespace {

auto in_order(const IntegerRing& points) {
  return [&points](Index i, Index k) {
    const Point2<Integer>&p = points[i], &q = points[k];
    return p.x < q.x || (p.x == q.x && p.y < q.y);
  };
}

/// The least value over an edge of the ring and a point that is not its end, over all of them. No point lies on the
/// right of an edge, and of the ring's corners one next to the edge is nearest.
template <class Value, class Point>
Value least_area(const std::vector<Point>& points, const std::vector<Index>& ring) {
  std::vector<bool> corner(points.size());
  for (const Index i : ring) corner[i] = true;
  std::vector<Index> others;
  for (Index i = 0; i < points.size(); ++i)
    if (!corner[i]) others.push_back(i);
  std::optional<Value> least;
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n; ++k) {
    const Point &p = points[ring[k]], &q = points[ring[(k + 1) % n]];
    const Value x(q.x - p.x), y(q.y - p.y);
    const auto note = [&](const Point& r) {
      Value area = x * Value(r.y - p.y) - y * Value(r.x - p.x);
      if (!least || area < *least) least = std::move(area);
    };
    note(points[ring[(k + 2) % n]]), note(points[ring[(k + n - 1) % n]]);
    for (const Index i : others) note(points[i]);
  }
  return *least;
}

std::optional<Rational> margin_of_convex_hull_2d(const IntegerRing& points, const std::vector<Index>& ring) {
  if (points.size() == 1) return std::nullopt;
  if (ring.size() == 2 && points.size() == 2) {
    const Vector2<Integer> v = points[1] - points[0];
    return points.actual_area(Rational(dot(v, v)));
  }
  if (ring.size() < 3) return Rational(0);
  return points.actual_area(points.words.empty() ? Rational(least_area<Integer>(points.ring.vertices, ring))
                                                 : rational(least_area<Int128>(points.words, ring)));
}

ConvexHull2 hull_of_convex_hull_2d(const std::vector<Index>& ring) {
  if (ring.size() == 1) return {0, ring[0], {}, {}};
  if (ring.size() == 2) return {1, {}, IndexPair{ring[0], ring[1]}, {}};
  return {2, {}, {}, ring};
}

void validate_convex_hull_2d(const std::vector<Point2d>& points) {
  validation::validate("points", points, rule::points);
}
void validate_convex_hull_2d(const std::vector<Point2<Rational>>& points) {
  if (points.empty()) throw InvalidInput("points", "at least 1 point");
}

/// The indices of an answer; empty if its fields are not those of its dimension.
std::vector<Index> named_by_convex_hull_2d(const ConvexHull2& hull) {
  if (hull.point.has_value() != (hull.dimension == 0) || hull.segment.has_value() != (hull.dimension == 1) ||
      hull.polygon.has_value() != (hull.dimension == 2)) {
    return {};
  }
  if (hull.point) return {*hull.point};
  if (hull.segment) return {hull.segment->i, hull.segment->j};
  return hull.polygon.value_or(std::vector<Index>());
}

bool between(const Integer& low, const Integer& x, const Integer& high) {
  return std::min(low, high) <= x && x <= std::max(low, high);
}

}  // namespace

template <Exact Number>
Truth<ConvexHull2> convex_hull_2d(const std::vector<Point2<Number>>& points) {
  validate_convex_hull_2d(points);
  const IntegerRing integers(Polygon2<Number>{points});
  std::vector<Index> all(integers.size());
  std::iota(all.begin(), all.end(), Index{0});
  std::vector<Index> ring =
      extreme_ring(all, in_order(integers), [&](Index p, Index q, Index r) { return integers.area(p, q, r); });
  return {hull_of_convex_hull_2d(ring), margin_of_convex_hull_2d(integers, ring), [ring = std::move(ring)] {
            const char* kind = ring.size() == 1 ? "one_point" : ring.size() == 2 ? "segment" : "polygon";
            return Certificate{kind, {{"extreme", {ring.begin(), ring.end()}}}};
          }};
}
template Truth<ConvexHull2> convex_hull_2d(const std::vector<Point2d>&);
template Truth<ConvexHull2> convex_hull_2d(const std::vector<Point2<Rational>>&);

/// A ring that turns left at every vertex, with every point on the left of every edge or on it: each vertex is then the
/// one point of a wedge that holds all points, hence extreme, and each edge goes on to the next extreme point. As no
/// vertex comes twice, it goes round once.
std::string convex_hull_2d_defect(const std::vector<Point2d>& points, const ConvexHull2& hull) {
  const std::vector<Index> ring = named_by_convex_hull_2d(hull);
  if (ring.empty()) return "not the fields of its dimension";
  for (const Index i : ring) {
    if (i >= points.size()) return "no such point: " + std::to_string(i);
  }
  const IntegerRing integers(Polygon2d{points});
  for (std::size_t i = 0; i < ring.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (integers[ring[i]] == integers[ring[k]]) return "one point twice: " + std::to_string(ring[i]);
    }
  }
  if (hull.dimension == 2 && ring.size() < 3) return "fewer than three vertices";
  const std::size_t n = ring.size();
  for (std::size_t k = 0; k < n && n > 2; ++k) {
    if (integers.turn(ring[k], ring[(k + 1) % n], ring[(k + 2) % n]) <= 0) return "no turn to the left";
  }
  const auto outside = [](Index i) { return "outside is point " + std::to_string(i); };
  const auto turn = [&](Index p, Index q, Index r) { return integers.turn(p, q, r); };
  if (n > 2) {
    const auto beyond = point_outside(ring, integers.size(), in_order(integers), turn);
    return beyond ? outside(*beyond) : "";
  }
  for (Index i = 0; i < integers.size(); ++i) {
    const auto &p = integers[i], &a = integers[ring[0]], &b = integers[ring.back()];
    if (!(between(a.x, p.x, b.x) && between(a.y, p.y, b.y))) return outside(i);
    if (n == 2 && integers.turn(ring[0], ring[1], i) != 0) return outside(i);
  }
  return "";
}

}  // namespace touchstone::oracle
