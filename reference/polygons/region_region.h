// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "reference/lines/orientation.h"
#include "reference/polygons/point_in_region.h"

namespace touchstone::reference {

/// Decides whether two regions, polygons with holes, have common points, and common interior points.
///
/// No page of the deck asks this. The tests are those of deck p. 18-19 by all rings: regions overlap where a vertex of
/// one lies inside the other, otherwise where an edge of one crosses an edge of the other; a vertex on the other's
/// boundary is a touch. a, b: as in reference/polygons/point_in_region.h, any unit of length, the same for both, and
/// refused as there, a before b. `overlapping`: a common interior point (one inside the other and coincident regions
/// included); `touching`: common points, all of them on both boundaries, as of a region and a polygon that fills its
/// hole; `disjoint`: none, as of a region and what lies in its hole.
///
/// Where no vertex lies inside the other region and no edges cross, the tests cannot see an overlap, as in
/// reference/polygons/polygon_polygon.h: such regions are `touching` even in exact arithmetic (cause: algorithm). Where
/// edges of two outer rings cross in a point in which holes touch both, the tests see an overlap that the holes may
/// have taken away.
///
/// Rounding: every decision is one of reference/polygons/point_in_polygon.h or a sign of reference/lines/orientation.h;
/// the double version decides as the formula does in exact arithmetic where each of those is beyond its margin given
/// there.
template <class Real>
Contact region_region(const Region2<Real>& a, const Region2<Real>& b) {
  const auto each_ring = [](const Region2<Real>& region, const auto& call) {
    call(region.outer);
    for (const Polygon2<Real>& hole : region.holes) call(hole);
  };
  bool touch = false, overlap = false;
  for (const auto& [one, other] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    each_ring(*one, [&, solid = other](const Polygon2<Real>& ring) {
      for (const Point2<Real>& p : ring.vertices) {
        const Location location = point_in_region(*solid, p);
        overlap = overlap || location == Location::inside;
        touch = touch || location == Location::boundary;
      }
    });
  }
  const auto apart = [](Side s, Side t) { return s != t && s != Side::on && t != Side::on; };
  each_ring(a, [&](const Polygon2<Real>& one) {
    each_ring(b, [&](const Polygon2<Real>& other) {
      for (std::size_t i = 0; i < one.size(); ++i) {
        for (std::size_t j = 0; j < other.size(); ++j) {
          const Point2<Real>&p = one[i], &q = one.next(i), &r = other[j], &s = other.next(j);
          overlap = overlap || (apart(orientation(p, q, r), orientation(p, q, s)) &&
                                apart(orientation(r, s, p), orientation(r, s, q)));
        }
      }
    });
  });
  return overlap ? Contact::overlapping : touch ? Contact::touching : Contact::disjoint;
}

}  // namespace touchstone::reference
