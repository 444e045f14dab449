// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// Locates a point relative to a k-DOP, the solid between pairs of parallel planes.
///
/// Deck p. 43: the point P is in the volume where
///     d1 <= N . P <= d2
/// for the normal N of every slab [d1, d2]. Closed: P is outside where a slab does not hold N . P, otherwise on the
/// boundary where N . P is an end of a slab, otherwise inside. point and d / |N|: any unit of length, the same for
/// both; N of any length, in any order. Normals may be parallel.
/// A flat slab (d1 == d2) has no interior: the answer is `boundary` at most. So it is where a slab touches the solid
/// from outside. The solid may be empty, then every point is outside, or unbounded.
/// Refused by robust and oracle with field and rule, the first that applies: no normals ("kdop.normals", "at least 1
/// normal"), lists of different lengths ("kdop.slabs", "as many slabs as normals"), then slab by slab: NaN or infinity
/// ("kdop.normals[i][k]", "finite number"), N = 0 ("kdop.normals[i]", "nonzero normal"), NaN or infinity in d1 or d2
/// ("kdop.slabs[i][k]", "finite number"), d1 > d2 ("kdop.slabs[i][1]", "min <= max"); then the point ("point[k]",
/// "finite number").
///
/// In exact arithmetic the formula is always right. Margin: of P's squared distances from the nearer plane of each
/// slab, the least, if no slab excludes P; otherwise the greatest among those that do.
///
/// Rounding (binary64, to nearest, u = 2^-53): with X, Y, Z the three products as computed, N . P is off by at most
///     e = (3 + 8u) u (|X| + |Y| + |Z|) + 2^-1073
/// unless something overflows: a product rounds and goes through two sums, each of which rounds, (1 + u)^3 - 1 over
/// 1 - u is below (3 + 8u) u, and gradual underflow costs half of 2^-1074 a product. The comparisons are exact. So
/// where N . P as computed is farther than e from both ends of every slab, the double version is right. No number is
/// returned.
template <class Real>
Location point_in_kdop(const Kdop3<Real>& kdop, const Point3<Real>& point) {
  bool beyond = false, on = false;
  for (std::size_t i = 0; i < kdop.normals.size(); ++i) {
    const Real value = dot(kdop.normals[i], Vector3<Real>{point.x, point.y, point.z});
    const auto& [d1, d2] = kdop.slabs[i];
    if (value < d1 || value > d2) beyond = true;
    else if (value == d1 || value == d2) on = true;
  }
  return beyond ? Location::outside : on ? Location::boundary : Location::inside;
}

}  // namespace touchstone::reference
