// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// Locates a point relative to a polygon, by the ray test.
///
/// Deck p. 14-15: a ray from the point to +x; inside where it crosses the edges an odd number of times. Special cases:
/// an edge counts only if one of its ends is strictly above the ray and the other is not, so that a vertex on the ray
/// is passed once or not at all and an edge along the ray does not count; a point on an edge is `boundary`. polygon,
/// point: any unit of length, the same for both. Any closed ring in either direction, even-odd: it may cross itself,
/// touch itself, have repeated vertices, flat ones and spikes, or lie on one line. The union of its edges is its
/// boundary. Degenerate: an edge of length 0 is a point of the boundary; a ring on one line has no inside. A last
/// position that repeats the first is no vertex: it changes nothing, but three positions with it are two vertices.
/// Fewer than 3 vertices ("at least 3 vertices"), NaN or infinity ("finite number"): refused by robust and oracle with
/// the field.
///
/// Margin: the least squared distance of the point from an edge. Rounding (binary64, to nearest, u = 2^-53):
/// comparisons do not round, so only the place X = ax + T (bx - ax), T = (y - ay) / (by - ay), of an edge that counts
/// can be wrong. With T, D = bx - ax, Q = T D and X as computed, T is off by at most e = (3 + 5u) u |T| + 2^-1074 (two
/// differences and a quotient, which may underflow), D by u |D|, Q by u |Q| + 2^-1075 and the sum by u |X|. So X is off
/// by at most E = e |D| + (|T| + e) u |D| + u (|Q| + |X|) + 2^-1075, unless a difference overflows. The true place is a
/// point of the edge at the height of the point, so it is at least as far away as the edge: the double version is right
/// where the margin exceeds the square of the greatest E of an edge that counts. In exact arithmetic the formula is
/// always right.
template <class Real>
Location point_in_polygon(const Polygon2<Real>& polygon, const Point2<Real>& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2<Real>&a = polygon[i], &b = polygon.next(i);
    if (a == point) return Location::boundary;
    if (a.y == point.y && b.y == point.y) {  // along the ray
      if ((a.x < point.x) != (b.x < point.x)) return Location::boundary;
    } else if ((a.y > point.y) != (b.y > point.y)) {
      const Real t = Real((point.y - a.y) / (b.y - a.y)), x = Real(a.x + Real(t * Real(b.x - a.x)));
      if (x == point.x) return Location::boundary;
      if (x > point.x) inside = !inside;
    }
  }
  return inside ? Location::inside : Location::outside;
}

}  // namespace touchstone::reference
