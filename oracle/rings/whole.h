// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/thin_shapes.h"
#include "geometry/polygons.h"
#include "oracle/exact/decode.h"

namespace touchstone::oracle {

/// A ring in integers times one positive unit. Signs and ratios are those of the ring itself; an area is multiplied by unit^2.
struct WholeRing {
  Polygon2<Integer> ring;
  Rational unit;

  template <class Number>
  explicit WholeRing(const Polygon2<Number>& polygon) {
    Integer denominator(1);
    std::vector<Point2<Rational>> points;
    for (const auto& p : polygon.vertices) {
      points.push_back({exact(p.x), exact(p.y)});
      mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), points.back().x.get_den_mpz_t());
      mpz_lcm(denominator.get_mpz_t(), denominator.get_mpz_t(), points.back().y.get_den_mpz_t());
    }
    const auto whole = [&](const Rational& x) { return Integer(x.get_num() * (denominator / x.get_den())); };
    for (const auto& p : points) ring.vertices.push_back({whole(p.x), whole(p.y)});
    unit = Rational(Integer(1), denominator);
  }

  std::size_t size() const { return ring.size(); }
  const Point2<Integer>& operator[](std::size_t i) const { return ring[i]; }
  Segment2<Integer> edge(std::size_t i) const { return {ring[i], ring.next(i)}; }
  /// The turn from p -> q to q -> r: twice the area of that triangle.
  static Integer turn(const Point2<Integer>& p, const Point2<Integer>& q, const Point2<Integer>& r) {
    return cross(q - p, r - p);
  }
};

}  // namespace touchstone::oracle
