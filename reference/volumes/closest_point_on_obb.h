// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/closest.h"
#include "reference/volumes/sphere_obb.h"

namespace touchstone::reference {

/// The point of an oriented box, as a closed solid, that is nearest to a point, its distance and the square of that.
///
/// No page of the deck asks this. The formula is the textbook's (Ericson, Real-Time Collision Detection, 5.1.4), with
/// half axes that are not of length 1, and combines two: p. 27's box, in whose frame the point has the coordinates
///     d . u / u . u
/// for each half axis u, d being the displacement from the center of the box; and p. 48-50's nearest point of a box, to
/// which each coordinate is moved into [-1, 1].
/// point, obb: any unit of length, the same for both; the squared distance is in its square. There is always exactly
/// one nearest point, because a box is closed and convex. A point of the box, on its boundary too, is its own, at
/// distance 0. The half axes need not be at right angles: any three independent ones make a solid, a parallelepiped,
/// and the truth is the projection onto this solid.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("point[0]", "obb.half_axes[0][0]" ...,
/// "finite number"); half axes that are linearly dependent, one of length zero among them ("obb.half_axes", "linearly
/// independent").
///
/// In exact arithmetic the formula is right where the half axes are at right angles. Otherwise the point that it takes
/// is in the box, but another may be nearer, and a point of the box may not be its own (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53), where every a . a as computed is at least 2^-960 and nothing overflows:
/// each coordinate X of the point is off by e(X) as in sphere_obb.h, from that in exact arithmetic. Let e be the sum of
/// these, and D the distance in exact arithmetic. As in closest_point_on_segment.h, the distance as computed is off by
/// at most e + 4u (D + e) + 2^-536, and its square by 2 D e + e^2 + 6u (D + e)^2 + 2^-1072. ulps: 63 roundings behind
/// the distance (three differences, eleven in each of three coefficients, 18 in the point; three differences, three
/// squares, two sums, the root).
template <class Real>
ClosestPoint3<Real> closest_point_on_obb(const Point3<Real>& point, const Obb3<Real>& obb) {
  using std::sqrt;
  const Point3<Real> x = nearest_in_obb(point, obb);
  const Real square = dot(point - x, point - x);
  return {x, square, Real(sqrt(square))};
}

}  // namespace touchstone::reference
