// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "reference/lines/orientation.h"
#include "reference/polygons/point_in_polygon.h"

namespace touchstone::reference {

/// Decides whether two simple polygons, as closed solids, have common points, and common interior points.
///
/// Deck p. 18-19: they overlap where one contains a vertex of the other, otherwise where an edge of one crosses an edge
/// of the other. The slide answers yes or no; the third answer is read from the same tests: a vertex on the other's
/// boundary is a touch. a, b: rings in either direction, any unit of length, the same for both; flat vertices are
/// valid. `overlapping`: a common interior point (one inside the other and coincident polygons included); `touching`:
/// common points, all of them on both boundaries; `disjoint`: none. Refused by robust and oracle, a before b: fewer
/// than 3 vertices ("a", "at least 3 vertices"); NaN or infinity (field, "finite number"); an edge of length zero or
/// edges that meet at a point other than the vertex of neighbours (the vertex, "different from vertex i: drop one of
/// the two", "simple: ..."; geometry/validation.h). A last position that repeats the first is no vertex: it is dropped,
/// once.
///
/// Where every vertex of both lies outside the other or on its boundary and no edges cross in their interiors, the
/// slide's tests cannot see an overlap: coincident polygons, a diamond inscribed in a square, a bar with its ends on
/// two edges are `touching` even in exact arithmetic (cause: algorithm).
///
/// Rounding: every decision is one of reference/polygons/point_in_polygon.h or a sign of reference/lines/orientation.h;
/// the double version decides as the formula does in exact arithmetic where each of those is beyond its margin given
/// there.
template <class Real>
Contact polygon_polygon(const Polygon2<Real>& a, const Polygon2<Real>& b) {
  bool touch = false;
  for (const auto& [vertices, solid] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    for (const Point2<Real>& p : vertices->vertices) {
      const Location location = point_in_polygon(*solid, p);
      if (location == Location::inside) return Contact::overlapping;
      touch = touch || location == Location::boundary;
    }
  }
  const auto apart = [](Side s, Side t) { return s != t && s != Side::on && t != Side::on; };
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      const Point2<Real>&p = a[i], &q = a.next(i), &r = b[j], &s = b.next(j);
      if (apart(orientation(p, q, r), orientation(p, q, s)) && apart(orientation(r, s, p), orientation(r, s, q))) {
        return Contact::overlapping;
      }
    }
  }
  return touch ? Contact::touching : Contact::disjoint;
}

}  // namespace touchstone::reference
