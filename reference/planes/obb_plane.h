// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/volumes/obb_obb.h"

namespace touchstone::reference {

/// Decides whether an oriented box and the half-space behind a plane, as closed solids, overlap, only touch, or
/// neither.
///
/// No page of the deck asks this. The formula is the test of box against plane of Ericson (Real-Time Collision
/// Detection, 5.2.3): of p. 22's E(p) = N . p + d, the height over the plane in units of |N|, and p. 27's box of center
/// c and half axes h. They are disjoint where
///     E(c) > sum |N . h|,
/// and `touching` where both are equal: E of the box's lowest corner is the difference.
/// The half-space is the set of points with N . p + d <= 0: the plane and its back, as point_plane has it; its front is
/// where N points to. obb, plane: center, half axes and d / |N| in any unit of length, the same for all; N of any
/// length but 0. Shapes are closed: a box in front of the plane that only reaches it with a corner, an edge or a face
/// is `touching`. A box within the half-space overlaps it, touching the plane from behind or not.
/// The half axes need not be at right angles: the box is the parallelepiped that they span, exactly. It has an
/// interior, however flat.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("obb.center[0]", "plane.offset" ..., "finite
/// number"); half axes that are linearly dependent, one of length zero among them ("obb.half_axes", "linearly
/// independent"); N = 0 ("plane.normal", "nonzero normal").
///
/// In exact arithmetic the formula is right.
///
/// Rounding (binary64, to nearest, u = 2^-53): let Z be the sum of |d| and the magnitudes of the twelve products of
/// coordinates, taken exactly. A product rounds, and goes through three sums on the left and through four on the right,
/// each of which rounds; gradual underflow costs 2^-1075 a product; the comparison is exact. So where both sides, taken
/// exactly, differ by more than ((1 + u)^5 - 1) Z + 2^-1071 < (5 + 11u) u Z + 2^-1071, the double version answers as
/// exact arithmetic does, unless something overflows. No number is returned.
template <class Real>
Contact obb_plane(const Obb3<Real>& obb, const Plane<Real>& plane) {
  const Point3<Real>& c = obb.center;
  const Real e = Real(dot(plane.normal, Vector3<Real>{c.x, c.y, c.z}) + plane.offset),
             reach = reach_along(plane.normal, obb.half_axes);
  return e > reach ? Contact::disjoint : e < reach ? Contact::overlapping : Contact::touching;
}

}  // namespace touchstone::reference
