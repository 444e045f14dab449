// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/polygons/point_in_polygon.h"

namespace touchstone::reference {

/// Locates a point relative to a region, a polygon with holes, by a ray test for each ring.
///
/// No page of the deck asks this. The formula is that of deck p. 14-15, ring by ring: inside where the point is inside
/// the outer ring and outside every hole. region: the closed polygon of the outer ring without the open insides of the
/// holes, so the edges of holes are its boundary, and so is a point where a hole touches the outer ring or another
/// hole. Any unit of length, the same for both. Rings in either direction, flat vertices included; a last position that
/// repeats the first is no vertex: it is dropped, once. No holes are valid. A hole may touch the outer ring and other
/// holes, in single points: so the inside need not be connected.
///
/// Refused by robust and oracle: NaN or infinity (field, "finite number"); fewer than 3 vertices ("region.holes[1]",
/// "at least 3 vertices"); then a ring that is not simple, the outer one first (its vertex, "region.holes[1][2]", by
/// the rules of polygon_polygon); then the first hole that leaves the outer ring or shares more than single points with
/// it ("inside the outer ring, which it may touch in single points only"), or that lies in an earlier hole, contains or
/// crosses it, or shares more than single points with it ("outside hole i, which it may touch in single points only").
///
/// Margin: the least squared distance of the point from an edge. Rounding: that of
/// reference/polygons/point_in_polygon.h for each ring, so the double version is right where the margin exceeds the
/// square of the greatest E there of an edge that counts. In exact arithmetic the formula is always right.
template <class Real>
Location point_in_region(const Region2<Real>& region, const Point2<Real>& point) {
  const Location in_outer = point_in_polygon(region.outer, point);
  if (in_outer != Location::inside) return in_outer;
  for (const Polygon2<Real>& hole : region.holes) {
    const Location in_hole = point_in_polygon(hole, point);
    if (in_hole == Location::boundary) return Location::boundary;
    if (in_hole == Location::inside) return Location::outside;
  }
  return Location::inside;
}

}  // namespace touchstone::reference
