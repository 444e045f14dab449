// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: `boundary` by definition, every edge asked. Otherwise the parity of the crossings of a ray in a direction
/// that is parallel to no line through the point and a vertex; two such rays have to agree. Margin: the least squared
/// distance of the point from an edge.
template <Exact Number = double>
Truth<Location> point_in_polygon(const Polygon2<Number>& polygon, const Point2<Number>& point);

/// The answer of `point_in_polygon` alone by the winding number, counted in quarter turns without an angle: its parity
/// is that of the crossings. The ring is relative to the point at the origin. With |coordinate| < 2^k, Word needs k + 1
/// bits and Wide 2k + 3.
template <class Wide, class Word>
Location location_by_winding(const Polygon2<Word>& around) {
  const Word zero(0);
  const auto quadrant = [&](const Point2<Word>& v) {
    return v.y > zero || (v.y == zero && v.x > zero) ? (v.x > zero ? 0 : 1) : (v.x < zero ? 2 : 3);
  };
  std::int64_t quarters = 0;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const Point2<Word>&a = around[i], &b = around.next(i);
    const Wide left = Wide(a.x) * Wide(b.y), right = Wide(a.y) * Wide(b.x);
    if (left == right && Wide(a.x) * Wide(b.x) <= Wide(0) && Wide(a.y) * Wide(b.y) <= Wide(0))
      return Location::boundary;
    const int step = (quadrant(b) - quadrant(a) + 4) % 4;
    quarters += step == 3 ? -1 : step == 2 ? (left > right ? 2 : -2) : step;
  }
  return quarters / 4 % 2 != 0 ? Location::inside : Location::outside;
}

/// The same for doubles.
Location point_in_polygon_location(const Polygon2d& polygon, const Point2d& point);

}  // namespace touchstone::oracle
