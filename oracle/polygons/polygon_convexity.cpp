// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/polygon_convexity.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/validation.h"
#include "oracle/exact/systems/common_points.h"
#include "oracle/exact/systems/elimination.h"
#include "oracle/lines/segment_segment.h"
#include "oracle/rings/boxes.h"
#include "oracle/rings/simple.h"
#include "oracle/rings/whole.h"

namespace touchstone::oracle {
namespace {

constexpr PolygonConvexity degenerate{PolygonClass::degenerate, false, Winding::none};
constexpr PolygonConvexity not_simple{PolygonClass::not_simple, false, Winding::none};

std::optional<std::size_t> repeated_neighbour(const IntegerRing& r) {
  for (std::size_t i = 0; i < r.size(); ++i) {
    if (r[i] == r.ring.next(i)) return i;
  }
  return std::nullopt;
}

/// Neighbours differ.
bool on_one_line(const IntegerRing& r) {
  for (Index i = 2; i < r.size(); ++i) {
    if (r.turn(0, 1, i) != 0) return false;
  }
  return true;
}

/// An edge and two vertices strictly on different sides of its line.
struct Straddled {
  Index edge, left, right;
};
/// True if the greatest of the normal form u x (p - a) over a box, times `sign`, is positive.
bool may_lie_beside(const Segment2<Integer>& line, int sign, const Boxes::Box& box) {
  const Vector2<Integer> u = Integer(sign) * (line.b - line.a);
  const Integer &x = sgn(u.y) > 0 ? *box.left : *box.right, &y = sgn(u.x) > 0 ? *box.top : *box.bottom;
  return u.x * (y - line.a.y) > u.y * (x - line.a.x);
}

/// The first such edge, and the last vertex on each side.
std::optional<Straddled> straddled(const IntegerRing& r) {
  const std::vector<Segment2<Integer>> edges = r.edges();
  const Boxes boxes(edges);
  for (Index i = 0; i < r.size(); ++i) {
    const auto last_beside = [&](int sign) {
      std::optional<Index> found;
      const auto may = [&](const Boxes::Box& box) { return may_lie_beside(edges[i], sign, box); };
      boxes.descending(may, [&](std::size_t j) {
        if (r.turn(i, r.after(i), static_cast<Index>(j)) == sign) found = static_cast<Index>(j);
        return found.has_value();
      });
      return found;
    };
    const auto left = last_beside(1), right = left ? last_beside(-1) : std::nullopt;
    if (left && right) return Straddled{i, *left, *right};
  }
  return std::nullopt;
}

/// In squared units; the ring is simple.
Rational room(const IntegerRing& r, bool convex, int winding) {
  const std::vector<Segment2<Integer>> edges = r.edges();
  const Boxes boxes(edges);
  std::optional<SquaredLength<Integer>> clearance, greatest_dent;
  for (Index i = 0; i < r.size(); ++i) {
    const Integer turn = r.area(r.before(i), i, r.after(i));
    const Vector2<Integer> base = r.ring.next(i) - r.ring.previous(i);
    // In a simple ring the neighbours of a vertex cannot coincide, nor can the vertex be a spike: the base is not 0.
    const SquaredLength<Integer> height{Integer(turn * turn), dot(base, base)};
    if (convex && (!clearance || height < *clearance)) clearance = height;
    if (sgn(turn) * winding < 0 && (!greatest_dent || *greatest_dent < height)) greatest_dent = height;
    boxes.lessen(clearance, r[i], [&](std::size_t j) { return j != i && r.after(static_cast<Index>(j)) != i; });
  }
  const SquaredLength<Integer>& least = !convex && *greatest_dent < *clearance ? *greatest_dent : *clearance;
  return quotient(least.numerator, least.denominator);
}

/// The least squared distance of an end of either edge from the other, unless it is at most `deepest`.
std::optional<SquaredLength<Integer>> least_end_distance_beyond(const SquaredLength<Integer>& deepest,
                                                                const Segment2<Integer>& e,
                                                                const Segment2<Integer>& f) {
  std::optional<SquaredLength<Integer>> least;
  for (const auto& [end, edge] : {std::pair(&e.a, &f), std::pair(&e.b, &f), std::pair(&f.a, &e), std::pair(&f.b, &e)}) {
    SquaredLength<Integer> distance = squared_distance(*end, *edge, Extent::segment);
    if (!(deepest < distance)) return std::nullopt;
    if (!least || distance < *least) least = std::move(distance);
  }
  return least;
}

/// In squared units, for a ring that is not simple. Two edges that meet in a point have an end within half the length
/// of either edge from the other: so the longest come first, and those that are too short for more are skipped.
Rational depth(const IntegerRing& r) {
  const std::vector<Segment2<Integer>> edges = r.edges();
  const Boxes boxes(edges);
  std::vector<Integer> lengths;
  for (const auto& e : edges) lengths.push_back(dot(e.b - e.a, e.b - e.a));
  std::vector<Index> order(r.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index i, Index j) { return lengths[i] > lengths[j]; });
  std::vector<Index> rank(r.size());
  for (Index k = 0; k < r.size(); ++k) rank[order[k]] = k;
  SquaredLength<Integer> deepest{Integer(0), Integer(1)};
  const auto too_short = [&](std::size_t j) { return lengths[j] * deepest.denominator <= 4 * deepest.numerator; };
  for (const Index i : order) {
    if (too_short(i)) break;
    const Boxes::Box own = Boxes::box_of(edges[i]);
    const auto may_meet = [&own](const Boxes::Box& box) { return Boxes::meet(own, box); };
    boxes.ascending(0, may_meet, [&](std::size_t j) {
      if (rank[j] <= rank[i] || too_short(j)) return false;
      const auto least = least_end_distance_beyond(deepest, edges[i], edges[j]);  // 0 where ends are shared
      if (least && segment_segment_relation<Integer>(edges[i], edges[j]) == SegmentRelation::point) deepest = *least;
      return false;
    });
  }
  return quotient(deepest.numerator, deepest.denominator);
}

/// The parameter of point p on a segment that contains it.
Rational parameter(const Point2<Rational>& p, const Segment2<Rational>& s) {
  const Vector2<Rational> along = s.b - s.a, to = p - s.a;
  return Rational(dot(to, along) / dot(along, along));
}

/// Two edges and the parameters of a common point that is not a vertex shared by neighbours.
template <class Number>
Certificate common_point_polygon_convexity(const validation::RingDefect& defect, const Segment2<Number>& a,
                                           const Segment2<Number>& b) {
  const auto common = segment_segment(a, b).answer;
  std::vector<Rational> at;
  if (common.point) {
    at = {*common.ta, *common.tb};
  } else {
    const auto exactly = [](const Segment2<Number>& s) {
      return Segment2<Rational>{{exact(s.a.x), exact(s.a.y)}, {exact(s.b.x), exact(s.b.y)}};
    };
    const auto& [p, q] = *common.overlap;
    const Point2<Rational> middle{Rational((p.x + q.x) / 2), Rational((p.y + q.y) / 2)};
    at = {parameter(middle, exactly(a)), parameter(middle, exactly(b))};
  }
  return {"common_point", {{"edges", {Rational(defect.first), Rational(defect.second)}}, {"parameters", at}}};
}

Certificate common_line(const Point2<Integer>& p, const Point2<Integer>& q, const Rational& unit) {
  const Vector2<Integer> along = q - p;
  const Rational offset((-along.y * p.x + along.x * p.y) * unit);
  return {"common_line", {{"normal", {Rational(-along.y), Rational(along.x)}}, {"offset", {offset}}}};
}

template <class Number>
Truth<PolygonConvexity> truth_polygon_convexity(const Polygon2<Number>& given) {
  validation::validate("polygon", given);
  const validation::OpenRing open(given);
  const Polygon2<Number>& polygon = *open;
  const IntegerRing r(polygon);
  if (const auto i = repeated_neighbour(r))
    return {degenerate, Rational(0), [i = *i] {
              return Certificate{"repeated_neighbour", {{"vertex", {Rational(i)}}}};
            }};
  if (on_one_line(r))
    return {degenerate, Rational(0), [p = r[0], q = r[1], unit = r.unit] { return common_line(p, q, unit); }};
  if (const auto defect = ring_defect(r)) {
    const auto edge = [&](std::size_t i) { return Segment2<Number>{polygon[i], polygon.next(i)}; };
    return {not_simple, r.actual_area(depth(r)), [defect = *defect, a = edge(defect->first), b = edge(defect->second)] {
              return common_point_polygon_convexity(defect, a, b);
            }};
  }
  const auto found = straddled(r);
  const bool convex = !found;
  const Rational area = r.actual_area(Rational(r.area()));
  const int winding = sgn(area);
  bool strict = convex;
  for (Index i = 0; i < r.size(); ++i) strict = strict && r.turn_at(i) != 0;
  return {{convex ? PolygonClass::convex : PolygonClass::concave, strict, winding > 0 ? Winding::ccw : Winding::cw},
          r.actual_area(room(r, convex, winding)),
          [found, area]() -> Certificate {
            if (!found) return {"one_side", {{"doubled_area", {area}}}};
            return {"both_sides",
                    {{"edge", {Rational(found->edge)}}, {"vertices", {Rational(found->left), Rational(found->right)}}}};
          }};
}

}  // namespace

template <Exact Number>
Truth<PolygonConvexity> polygon_convexity(const Polygon2<Number>& polygon) {
  return truth_polygon_convexity(polygon);
}
template Truth<PolygonConvexity> polygon_convexity(const Polygon2d&);
template Truth<PolygonConvexity> polygon_convexity(const Polygon2<Rational>&);

}  // namespace touchstone::oracle
