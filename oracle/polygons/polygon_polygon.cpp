// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/polygon_polygon.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "oracle/exact/decode.h"
#include "oracle/exact/rational_door.h"
#include "oracle/rings/simple.h"

namespace touchstone::oracle {
namespace {

using Point = Point2<Rational>;
using Vector = Vector2<Rational>;
using Edge = Segment2<Rational>;

/// Both rings in whole numbers of one unit.
struct Rings {
  std::vector<Edge> a, b;
  Rational unit;
};

template <class Number>
void admit(const char* field, const Polygon2<Number>& ring) {
  door::admit(field, ring);
  if (const auto defect = ring_defect(ring)) door::refuse(field, *defect);
}

template <class Number>
Rings admitted(const Polygon2<Number>& a, const Polygon2<Number>& b) {
  admit("a", a), admit("b", b);
  Integer denominator(1);
  const auto divide = [&](const Rational& number) {
    mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), number.get_den_mpz_t());
  };
  for (const auto* ring : {&a, &b}) {
    for (const auto& p : ring->vertices) divide(exact(p.x)), divide(exact(p.y));
  }
  const Rational units(denominator);
  const auto edges = [&units](const Polygon2<Number>& ring) {
    std::vector<Edge> made;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const auto whole = [&](const auto& p) { return Point{Rational(exact(p.x) * units), Rational(exact(p.y) * units)}; };
      made.push_back({whole(ring[i]), whole(ring.next(i))});
    }
    return made;
  };
  return {edges(a), edges(b), Rational(1 / units)};
}

bool within(const Rational& number, const Rational& end, const Rational& other_end) {
  return std::min(end, other_end) <= number && number <= std::max(end, other_end);
}

bool lies_on(const Point& p, const Edge& e) {
  return sgn(cross(Vector(e.b - e.a), Vector(p - e.a))) == 0 && within(p.x, e.a.x, e.b.x) && within(p.y, e.a.y, e.b.y);
}

/// A common point of two edges; the only one where their directions differ.
std::optional<Point> common_point(const Edge& e, const Edge& f) {
  if (std::max(e.a.x, e.b.x) < std::min(f.a.x, f.b.x) || std::max(f.a.x, f.b.x) < std::min(e.a.x, e.b.x)) return std::nullopt;
  const Vector u = e.b - e.a, v = f.b - f.a, w = f.a - e.a;
  const Rational area = cross(u, v);
  if (sgn(area) == 0) {
    for (const auto& [p, edge] : {std::pair(e.a, f), std::pair(e.b, f), std::pair(f.a, e), std::pair(f.b, e)}) {
      if (lies_on(p, edge)) return p;
    }
    return std::nullopt;
  }
  const Rational s = cross(w, v) / area, t = cross(w, u) / area;
  if (!within(s, 0, 1) || !within(t, 0, 1)) return std::nullopt;
  return e.a + s * u;
}

struct Arrangement {
  std::vector<Rational> cuts;
  std::optional<Point> touch;
};

Arrangement arrangement_of(const std::vector<Edge>& a, const std::vector<Edge>& b) {
  Arrangement made;
  for (const auto* ring : {&a, &b}) {
    for (const Edge& e : *ring) made.cuts.push_back(e.a.x);
  }
  for (const Edge& e : a) {
    for (const Edge& f : b) {
      const std::optional<Point> p = common_point(e, f);
      if (!p) continue;
      made.cuts.push_back(p->x);
      if (!made.touch) made.touch = p;
    }
  }
  std::sort(made.cuts.begin(), made.cuts.end());
  made.cuts.erase(std::unique(made.cuts.begin(), made.cuts.end()), made.cuts.end());
  return made;
}

/// Where the vertical line at x meets the edges, from below; x is not that of a vertex.
std::vector<Rational> heights(const std::vector<Edge>& ring, const Rational& x) {
  std::vector<Rational> found;
  for (const Edge& e : ring) {
    if ((e.a.x < x) == (e.b.x < x)) continue;
    found.push_back(e.a.y + (x - e.a.x) / (e.b.x - e.a.x) * (e.b.y - e.a.y));
  }
  std::sort(found.begin(), found.end());
  return found;
}

std::optional<Point> common_interior_point(const std::vector<Edge>& a, const std::vector<Edge>& b,
                                           const std::vector<Rational>& cuts) {
  for (std::size_t k = 0; k + 1 < cuts.size(); ++k) {
    const Rational middle = (cuts[k] + cuts[k + 1]) / 2;
    const std::vector<Rational> of_a = heights(a, middle), of_b = heights(b, middle);
    for (std::size_t i = 0, j = 0; i < of_a.size() && j < of_b.size();) {
      const Rational low = std::max(of_a[i], of_b[j]), high = std::min(of_a[i + 1], of_b[j + 1]);
      if (low < high) return Point{middle, (low + high) / 2};
      of_a[i + 1] < of_b[j + 1] ? i += 2 : j += 2;
    }
  }
  return std::nullopt;
}

/// numerator / denominator, not reduced.
struct Fraction {
  Integer numerator, denominator;
};
bool operator<(const Fraction& x, const Fraction& y) {
  return x.numerator * y.denominator < y.numerator * x.denominator;
}

Fraction squared_distance(const Point2<Integer>& p, const Segment2<Integer>& e) {
  const Vector2<Integer> u = e.b - e.a, w = p - e.a;
  const Integer along = dot(w, u), length = dot(u, u);
  if (sgn(along) <= 0) return {dot(w, w), 1};
  if (along >= length) {
    const Vector2<Integer> from_end = p - e.b;
    return {dot(from_end, from_end), 1};
  }
  const Integer area = cross(u, w);
  return {area * area, length};
}

Rational margin_of(const Rings& rings) {
  const auto whole = [](const Point& p) { return Point2<Integer>{p.x.get_num(), p.y.get_num()}; };
  std::optional<Fraction> least;
  for (const auto& [vertices, edges] : {std::pair(&rings.a, &rings.b), std::pair(&rings.b, &rings.a)}) {
    for (const Edge& edge : *edges) {
      const Segment2<Integer> segment{whole(edge.a), whole(edge.b)};
      for (const Edge& vertex : *vertices) {
        Fraction distance = squared_distance(whole(vertex.a), segment);
        if (!least || distance < *least) least = std::move(distance);
      }
    }
  }
  Rational margin(least->numerator, least->denominator);
  margin.canonicalize();
  return Rational(margin * rings.unit * rings.unit);
}

template <class Number>
Truth<Contact> truth_of(const Polygon2<Number>& a, const Polygon2<Number>& b) {
  const Rings rings = admitted(a, b);
  const Arrangement found = arrangement_of(rings.a, rings.b);
  const Contact contact = common_interior_point(rings.a, rings.b, found.cuts) ? Contact::overlapping
                          : found.touch                                       ? Contact::touching
                                                                              : Contact::disjoint;
  return {contact, margin_of(rings)};
}

}  // namespace

Truth<Contact> polygon_polygon(const Polygon2d& a, const Polygon2d& b) { return truth_of(a, b); }
Truth<Contact> polygon_polygon(const Polygon2<Rational>& a, const Polygon2<Rational>& b) { return truth_of(a, b); }

Certificate polygon_polygon_certificate(const Polygon2d& a, const Polygon2d& b) {
  const Rings rings = admitted(a, b);
  const auto actual = [&rings](const Rational& whole) { return Rational(whole * rings.unit); };
  Arrangement found = arrangement_of(rings.a, rings.b);
  if (const auto p = common_interior_point(rings.a, rings.b, found.cuts)) {
    return {"common_interior_point", {{"point", {actual(p->x), actual(p->y)}}}};
  }
  for (Rational& cut : found.cuts) cut = actual(cut);
  Certificate slabs{"slabs", {{"cuts", found.cuts}}};
  if (found.touch) slabs.facts.push_back({"point", {actual(found.touch->x), actual(found.touch->y)}});
  return slabs;
}

}  // namespace touchstone::oracle
