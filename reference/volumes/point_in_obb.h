// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// The extent of a displacement along a half axis, minus that of the half axis itself; in units of the half axis'
/// length.
template <class Real>
Real beyond_half_axis(const Vector3<Real>& displacement, const Vector3<Real>& half_axis) {
  const Real along = dot(displacement, half_axis), reach = dot(half_axis, half_axis);
  return along < Real(0) ? Real(Real(0) - along - reach) : Real(along - reach);
}

/// Locates a point relative to an oriented bounding box, by its projections onto the axes.
///
/// Deck p. 27: a box in any orientation, given by its center and three half axes. The slide says no more; its test of a
/// point is that of an axis-aligned box on the box's own axes: with d = point - center,
///     |d . u| <= u . u
/// for each half axis u. Equality is `boundary` here.
/// obb, point: any unit of length, the same for both. The solid is closed: the points center + r u + s v + t w with r,
/// s, t in [-1, 1]. Half axes of any length but 0, in any order and direction, and right- or left-handed.
/// The half axes need not be at right angles: doubles seldom are, and any three independent ones make a solid, a
/// parallelepiped. The truth is that of this solid, however little the angles differ from right ones.
/// Refused by robust and oracle, the first that applies: NaN or infinity in the box ("obb.center[0]",
/// "obb.half_axes[0][0]" ..., "finite number"); half axes that are linearly dependent, one of length zero among them
/// ("obb.half_axes", "linearly independent"); NaN or infinity in the point ("point[0]" ..., "finite number").
///
/// In exact arithmetic the formula is right where the half axes are at right angles. Where they are not, it takes the
/// faces for perpendicular to the half axes and answers for another solid (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): let A be the sum of the magnitudes of the three products in d . a, for a
/// half axis a, and R = a . a, both exact. A product in the first goes through a difference, itself and two sums at
/// most, one in the second through one less: they are off by at most (4 + 7u) u A and (3 + 4u) u R, and where products
/// underflow together by 2^-1072 more; the comparison is exact. So where | |d . a| - R | exceeds the sum of these for
/// each half axis, unless something overflows, the double version answers as exact arithmetic does. No number is
/// returned.
template <class Real>
Location point_in_obb(const Obb3<Real>& obb, const Point3<Real>& point) {
  const Vector3<Real> displacement = point - obb.center;
  const auto& [u, v, w] = obb.half_axes;
  const Real beyond[] = {beyond_half_axis(displacement, u), beyond_half_axis(displacement, v),
                         beyond_half_axis(displacement, w)};
  bool on = false;
  for (const Real& by : beyond) {
    if (by > Real(0)) return Location::outside;
    if (!(by < Real(0))) on = true;
  }
  return on ? Location::boundary : Location::inside;
}

}  // namespace touchstone::reference
