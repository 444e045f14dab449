// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/validation.h"

namespace touchstone::reference {

/// Locates a point relative to a convex polygon, by the side of each edge.
///
/// Deck p. 16-17: for every edge a -> b
///     E = (y - ay)(bx - ax) - (x - ax)(by - ay);
/// inside where all E have one sign, outside where two have different ones. The slide does not say what E = 0 means:
/// here `boundary`, unless two others differ. polygon, point: any unit of length, the same for both. Either direction;
/// flat vertices are valid. Degenerate: none is valid. Refused by robust and oracle with field and rule, the first that
/// applies: fewer than 3 vertices (polygon, "at least 3 vertices"), NaN or infinity in either field ("finite number"),
/// a vertex that is the next one too (polygon[i], "different from vertex k: drop one of the two"), all vertices on one
/// line (polygon, "convex: vertices on one line have no inside"), an edge that meets another (polygon[i], "simple:
/// ..."), a vertex where the ring turns against its direction (polygon[i], "convex: ..."). A last position that repeats
/// the first is no vertex: it is dropped, once, before these rules.
///
/// In exact arithmetic the formula is always right: the sum of all E is twice the area, so that some E has the sign of
/// the inside, and where none has the other sign, the point is in the intersection of the closed half-planes of the
/// edges.
///
/// Margin: the least squared distance of the point from an edge. Rounding (binary64, to nearest, u = 2^-53): with L and
/// R the two products of an E as computed, it is off by at most (3 + 16u) u (|L| + |R|) + 2^-1073 unless something
/// overflows (reference/lines/orientation.h). If every |E| exceeds that, the double version is right.
template <class Real>
Location point_in_convex_polygon(const Polygon2<Real>& given, const Point2<Real>& point) {
  const validation::OpenRing open(given);
  const Polygon2<Real>& polygon = *open;
  bool left = false, right = false, on = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2<Real>&a = polygon[i], &b = polygon.next(i);
    const Real e = Real((point.y - a.y) * (b.x - a.x)) - Real((point.x - a.x) * (b.y - a.y));
    if (e > Real(0)) left = true;
    else if (e < Real(0)) right = true;
    else on = true;
  }
  return left && right ? Location::outside : on ? Location::boundary : Location::inside;
}

}  // namespace touchstone::reference
