// SPDX-License-Identifier: Apache-2.0
#include "oracle/rings/slabs.h"

#include <algorithm>
#include <utility>

#include "oracle/exact/systems/common_points.h"
#include "oracle/exact/systems/elimination.h"
#include "oracle/rings/boxes.h"

namespace touchstone::oracle {
namespace {

using Point = Point2<Rational>;
using Edge = Segment2<Integer>;

bool within(const Integer& number, const Integer& end, const Integer& other_end) {
  return std::min(end, other_end) <= number && number <= std::max(end, other_end);
}

bool lies_on(const Point2<Integer>& p, const Edge& e) {
  return sgn(cross(e.b - e.a, p - e.a)) == 0 && within(p.x, e.a.x, e.b.x) && within(p.y, e.a.y, e.b.y);
}

Point rational(const Point2<Integer>& p) { return {Rational(p.x), Rational(p.y)}; }

/// A common point of two edges; the only one if their directions differ.
std::optional<Point> common_point_of_edges(const Edge& e, const Edge& f) {
  if (boxes_apart(e, f)) return std::nullopt;
  const Vector2<Integer> u = e.b - e.a, v = f.b - f.a, w = f.a - e.a;
  const Integer area = cross(u, v);
  if (sgn(area) == 0) {
    for (const auto& [p, edge] : {std::pair(e.a, f), std::pair(e.b, f), std::pair(f.a, e), std::pair(f.b, e)}) {
      if (lies_on(p, edge)) return rational(p);
    }
    return std::nullopt;
  }
  const Integer s = cross(w, v), t = cross(w, u);
  if (!within(s, 0, area) || !within(t, 0, area)) return std::nullopt;
  const Rational along = quotient(s, area);
  return Point{Rational(e.a.x + along * u.x), Rational(e.a.y + along * u.y)};
}

}  // namespace

Arrangement arrangement_of(const std::vector<Edge>& a, const std::vector<Edge>& b) {
  Arrangement made;
  for (const auto* ring : {&a, &b}) {
    for (const Edge& e : *ring) made.cuts.emplace_back(e.a.x);
  }
  const Boxes boxes(b);
  for (const Edge& e : a) {
    const Boxes::Box own = Boxes::box_of(e);
    const auto may_meet = [&own](const Boxes::Box& box) { return Boxes::meet(own, box); };
    boxes.ascending(0, may_meet, [&](std::size_t j) {
      const std::optional<Point> p = common_point_of_edges(e, b[j]);
      if (p) made.cuts.push_back(p->x);
      if (p && !made.touch) made.touch = p;
      return false;
    });
  }
  std::sort(made.cuts.begin(), made.cuts.end());
  made.cuts.erase(std::unique(made.cuts.begin(), made.cuts.end()), made.cuts.end());
  return made;
}

namespace {

/// The edges of an area that a line crosses as it moves from slab to slab, between two adjacent cuts.
class Crossed {
 public:
  explicit Crossed(const std::vector<Edge>& edges) : waiting_(edges.size()) {
    std::transform(edges.begin(), edges.end(), waiting_.begin(), [](const Edge& e) { return &e; });
    std::sort(waiting_.begin(), waiting_.end(), [](const Edge* e, const Edge* f) { return left(*e) > left(*f); });
  }

  /// The points where the vertical line at x meets the edges, from below; x is not that of a vertex, and it ascends.
  std::vector<Rational> heights(const Rational& x) {
    for (; !waiting_.empty() && left(*waiting_.back()) < x; waiting_.pop_back()) crossed_.push_back(waiting_.back());
    std::erase_if(crossed_, [&x](const Edge* e) { return right(*e) < x; });
    std::vector<Rational> found;
    for (const Edge* e : crossed_)
      found.push_back(e->a.y + (x - e->a.x) * quotient(Integer(e->b.y - e->a.y), Integer(e->b.x - e->a.x)));
    std::sort(found.begin(), found.end());
    return found;
  }

 private:
  static const Integer& left(const Edge& e) { return std::min(e.a.x, e.b.x); }
  static const Integer& right(const Edge& e) { return std::max(e.a.x, e.b.x); }

  std::vector<const Edge*> waiting_, crossed_;
};

}  // namespace

std::optional<Point> common_interior_point(const std::vector<Edge>& a, const std::vector<Edge>& b,
                                           const std::vector<Rational>& cuts) {
  Crossed crossed_a(a), crossed_b(b);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Rational middle = (cuts[k] + cuts[k + 1]) / 2;
    const std::vector<Rational> of_a = crossed_a.heights(middle), of_b = crossed_b.heights(middle);
    for (std::size_t i = 0, j = 0; i < of_a.size() && j < of_b.size();) {
      const Rational low = std::max(of_a[i], of_b[j]), high = std::min(of_a[i + 1], of_b[j + 1]);
      if (low < high) return Point{middle, (low + high) / 2};
      of_a[i + 1] < of_b[j + 1] ? i += 2 : j += 2;
    }
  }
  return std::nullopt;
}

bool covers(const std::vector<Edge>& a, const std::vector<Edge>& b, const std::vector<Rational>& cuts) {
  Crossed crossed_a(a), crossed_b(b);
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Rational middle = (cuts[k] + cuts[k + 1]) / 2;
    const std::vector<Rational> of_a = crossed_a.heights(middle), of_b = crossed_b.heights(middle);
    for (std::size_t j = 0; j < of_b.size(); j += 2) {
      bool covered = false;
      for (std::size_t i = 0; i < of_a.size(); i += 2) covered |= of_a[i] <= of_b[j] && of_b[j + 1] <= of_a[i + 1];
      if (!covered) return false;
    }
  }
  return true;
}

SquaredLength<Integer> least_squared_distance(const std::vector<Edge>& a, const std::vector<Edge>& b) {
  std::optional<SquaredLength<Integer>> least;
  for (const auto& [vertices, edges] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const Boxes boxes(*edges);
    for (const Edge& vertex : *vertices) boxes.lessen(least, vertex.a, [](std::size_t) { return true; });
  }
  return *least;
}

Truth<Contact> contact_by_slabs(const std::vector<Edge>& a, const std::vector<Edge>& b, const Rational& unit) {
  Arrangement found = arrangement_of(a, b);
  auto inside = common_interior_point(a, b, found.cuts);
  const Contact contact = inside ? Contact::overlapping : found.touch ? Contact::touching : Contact::disjoint;
  const auto least = least_squared_distance(a, b);
  return {contact, Rational(quotient(least.numerator, least.denominator) * unit * unit),
          [found = std::move(found), inside = std::move(inside), unit] {
            const auto actual = [&unit](const Point& p) {
              return std::vector<Rational>{Rational(p.x * unit), Rational(p.y * unit)};
            };
            if (inside) return Certificate{"common_interior_point", {{"point", actual(*inside)}}};
            std::vector<Rational> cuts = found.cuts;
            for (Rational& cut : cuts) cut *= unit;
            Certificate slabs{"slabs", {{"cuts", std::move(cuts)}}};
            if (found.touch) slabs.facts.push_back({"point", actual(*found.touch)});
            return slabs;
          }};
}

}  // namespace touchstone::oracle
