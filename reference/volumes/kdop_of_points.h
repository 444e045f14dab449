// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/volumes.h"

namespace touchstone::reference {

/// The slabs of a k-DOP around points: for each normal N the least interval [d1, d2] that holds N . P of all points P.
///
/// Deck p. 43: the least and the greatest N . P are d1 and d2,
///     d1 = min(N . P),  d2 = max(N . P).
/// points: any unit of length; normals: of any length but 0, in any order, parallel ones too. The answer has a slab for
/// each normal, in their order, in units of |N| times that of the points. One point, equal points, points on one plane
/// across N: a flat slab, which is valid.
/// Refused by robust and oracle with field and rule, the first that applies: no points ("points", "at least 1 point"),
/// NaN or infinity ("points[i][k]", "finite number"), no normals ("normals", "at least 1 normal"), NaN or infinity
/// ("normals[i][k]", "finite number"), N = 0 ("normals[i]", "nonzero normal").
///
/// The truth has the exact d1 and d2. Doubles are to be rounded outwards, so that the slabs hold every point: robust
/// answers the greatest double that is not above d1 and the least that is not below d2, the best that there is. Beyond
/// the range these are the greatest double and an infinity: d1 above the range is the greatest double, d1 below it
/// -inf. An answer is right if each slab holds N . P of each point, exactly, and neither end is farther out than the
/// best, or than
///     t = 9 u S + 2^-1070, S the greatest of |X| + |Y| + |Z| over the points, X, Y, Z being the exact products,
/// from the exact one; where S + t is beyond the range, an infinity is not too far out either. So an honest
/// implementation in double (u = 2^-53, to nearest) is right: N . P as computed is off by at most
///     e = (3 + 8u) u S + 2^-1073
/// ((1 + u)^3 - 1 for a product's rounding and two sums, and half of 2^-1074 for each product that underflows); a bound
/// of that size, itself computed, is at most (3 + 32u) u S + 2^-1072; taken off, it leaves the end beyond the exact one
/// by at most twice that; and rounding the difference outwards costs at most 2 u (1 + 7u) S + 2^-1074 more.
///
/// In exact arithmetic the formula is always right. In double it rounds to nearest and not outwards, so it may lose
/// points, by at most e unless something overflows; the verdict says which point, of which slab and by how much. Where
/// every product and sum is exact, as on small integers, it is right. Nothing is decided: no margin.
template <class Real>
std::vector<Slab<Real>> kdop_of_points(const std::vector<Point3<Real>>& points,
                                       const std::vector<Vector3<Real>>& normals) {
  std::vector<Slab<Real>> slabs;
  for (const Vector3<Real>& normal : normals) {
    Slab<Real> slab{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Real value = dot(normal, Vector3<Real>{points[i].x, points[i].y, points[i].z});
      if (i == 0 || value < slab.min) slab.min = value;
      if (i == 0 || value > slab.max) slab.max = value;
    }
    slabs.push_back(slab);
  }
  return slabs;
}

}  // namespace touchstone::reference
