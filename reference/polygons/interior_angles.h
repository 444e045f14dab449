// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/polygons/polygon_convexity_interior_angles.h"

namespace touchstone::reference {

/// The interior angle at every vertex of a simple polygon, in radians, in the order of the vertices.
///
/// Deck p. 6: the angle between the edges e and f at a vertex is acos of their dot product over their lengths,
///     angle = acos(e . f / (|e| |f|));
/// where the sign of the cross product says reflex it is 2 pi less that. polygon: at least 3 vertices, any unit of
/// length; the last is joined to the first; either direction: the angle is that of the inside. 0 < angle < 2 pi; pi at
/// a flat vertex. robust answers the nearest doubles, which is 0 for an angle below 2^-1075 and the double nearest to 2
/// pi for one that is nearly that. Refused by robust and oracle: NaN or infinity (polygon[i][k], "finite number");
/// fewer than 3 vertices (polygon, "at least 3 vertices"); a polygon that is not simple (polygon[i], with the rules of
/// geometry/validation.h: a vertex that is the same as the next, "different from vertex i: drop one of the two", or an
/// edge that meets another at a point other than the vertex that neighbours share). So a polygon on one line is refused
/// too. A last position that repeats the first is no vertex and has no angle: it is dropped, once.
///
/// The slide does not say which side is the inside: the angles on the left of the ring add up to (n - 2) pi if it is
/// that side, to (n + 2) pi if it is the other.
///
/// Rounding (binary64, to nearest, u = 2^-53): with all differences of coordinates 0 or between 2^-200 and 2^200 in
/// magnitude the computed quotient is off by at most 11u, and the cross product by less than 5u |v| |w|
/// (reference/polygons/polygon_convexity_interior_angles.h). So where the sine of every angle exceeds 2^-20 in
/// magnitude, and there are fewer than 2^20 vertices, no vertex is taken for reflex wrongly, the inside is found, and
/// each angle a is off by at most
///     11u / (|sin a| - 2^-28) + 2^-48,
/// because acos is no steeper than that between the quotient and the cosine, and the library's acos (off by at most two
/// units in the last place, 2^-50), 2 pi and at most two differences from it (less than 2^-50 each) cost no more than
/// the rest. Near 0, pi and 2 pi acos is steep: an angle of 1e-8 may come out as 0. In exact arithmetic the formula is
/// always right. ulps: 18 roundings behind each angle (4 differences; 3 for the dot product and 3 for each square of a
/// length; their product, its root, the quotient, acos; 2 pi less it).
template <class Real>
std::vector<Real> interior_angles(const Polygon2<Real>& polygon) {
  using std::acos;
  std::vector<Real> angles = angles_on_the_left(polygon);
  const Real pi = acos(Real(-1));
  if (sum_of(angles) > Real(Real(static_cast<int>(angles.size())) * pi)) {
    for (Real& angle : angles) angle = Real(Real(2) * pi - angle);
  }
  return angles;
}

}  // namespace touchstone::reference
