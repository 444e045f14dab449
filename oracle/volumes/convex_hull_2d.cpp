// SPDX-License-Identifier: Apache-2.0
#include "oracle/volumes/convex_hull_2d.h"

#include <algorithm>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/numbers/wide.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {
namespace {

bool before(const Point2<Integer>& p, const Point2<Integer>& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

/// True if q is farther from p than r, which lies in the same direction.
bool farther(const Point2<Integer>& p, const Point2<Integer>& q, const Point2<Integer>& r) {
  return abs(q.x - p.x) + abs(q.y - p.y) > abs(r.x - p.x) + abs(r.y - p.y);
}

/// As seen from an extreme point all others lie within less than half a turn: turns from one to another order them.
std::vector<Index> wrapped(const IntegerRing& points) {
  Index least = 0;
  for (Index i = 1; i < points.size(); ++i) {
    if (before(points[i], points[least])) least = i;
  }
  std::vector<Index> ring{least};
  while (true) {
    const Index at = ring.back();
    Index next = at;
    for (Index i = 0; i < points.size(); ++i) {
      if (points[i] == points[at]) continue;
      const int turn = next == at ? -1 : points.turn(at, next, i);
      if (turn < 0 || (turn == 0 && farther(points[at], points[i], points[next]))) next = i;
    }
    if (next == at || next == least) return ring;
    ring.push_back(next);
  }
}

/// The least value over an edge of the ring and a point that is not its end, over all of them. No point lies on the
/// right of an edge.
template <class Value, class Point>
Value least_area(const std::vector<Point>& points, const std::vector<Index>& ring) {
  std::optional<Value> least;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Index from = ring[k], to = ring[(k + 1) % ring.size()];
    const Point &p = points[from], &q = points[to];
    const Value x(q.x - p.x), y(q.y - p.y);
    for (Index i = 0; i < points.size(); ++i) {
      if (i == from || i == to) continue;
      const Point& r = points[i];
      Value area = x * Value(r.y - p.y) - y * Value(r.x - p.x);
      if (!least || area < *least) least = std::move(area);
    }
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

template <class Number>
Truth<ConvexHull2> truth_convex_hull_2d(const std::vector<Point2<Number>>& points) {
  validate_convex_hull_2d(points);
  const IntegerRing integers(Polygon2<Number>{points});
  std::vector<Index> ring = wrapped(integers);
  return {hull_of_convex_hull_2d(ring), margin_of_convex_hull_2d(integers, ring), [ring = std::move(ring)] {
            const char* kind = ring.size() == 1 ? "one_point" : ring.size() == 2 ? "segment" : "polygon";
            return Certificate{kind, {{"extreme", {ring.begin(), ring.end()}}}};
          }};
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

Truth<ConvexHull2> convex_hull_2d(const std::vector<Point2d>& points) { return truth_convex_hull_2d(points); }

template <Exact Number>
Truth<ConvexHull2> convex_hull_2d(const std::vector<Point2<Number>>& points) {
  return truth_convex_hull_2d(points);
}
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
  for (Index i = 0; i < integers.size(); ++i) {
    const auto &p = integers[i], &a = integers[ring[0]], &b = integers[ring.back()];
    const std::string outside = "outside is point " + std::to_string(i);
    if (n < 3 && !(between(a.x, p.x, b.x) && between(a.y, p.y, b.y))) return outside;
    if (n == 2 && integers.turn(ring[0], ring[1], i) != 0) return outside;
    for (std::size_t k = 0; k < n && n > 2; ++k) {
      if (integers.turn(ring[k], ring[(k + 1) % n], i) < 0) return outside;
    }
  }
  return "";
}

}  // namespace touchstone::oracle
