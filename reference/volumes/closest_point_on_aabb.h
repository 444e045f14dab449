// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/volumes.h"

namespace touchstone::reference {

/// A coordinate moved to the nearer end of an interval, if it lies outside.
template <class Real>
Real clamped(const Real& x, const Real& min, const Real& max) {
  return x < min ? min : x > max ? max : x;
}

/// The point of an axis-aligned box, as a closed solid, that is nearest to a point. In the plane and in space.
///
/// Deck p. 48-50: coordinate by coordinate, a point below the box's minimum is moved to the minimum, one above its
/// maximum to the maximum; others stay:
///     q[i] = max(min[i], min(p[i], max[i])).
/// point, aabb: any unit of length, the same for both. There is always exactly one nearest point, because a box is
/// closed and convex. A point of the box, on its boundary too, is its own.
/// min == max on an axis is valid: of a flat box, a segment or a single point the answer has that coordinate.
/// NaN or infinity: refused by robust and oracle (field "point[0]", "aabb.min[0]" ..., "finite number"); so is min >
/// max (field "aabb.max[0]" ..., "min <= max").
///
/// Rounding: none; comparisons are exact, and each coordinate of the answer is a number of the input. So in every
/// environment that does not read subnormals as zero the double version is right for every input. Nothing is decided:
/// there is no margin. ulps: 0.
template <class Real>
Point2<Real> closest_point_on_aabb(const Point2<Real>& point, const Aabb2<Real>& aabb) {
  return {clamped(point.x, aabb.min.x, aabb.max.x), clamped(point.y, aabb.min.y, aabb.max.y)};
}
template <class Real>
Point3<Real> closest_point_on_aabb(const Point3<Real>& point, const Aabb3<Real>& aabb) {
  return {clamped(point.x, aabb.min.x, aabb.max.x), clamped(point.y, aabb.min.y, aabb.max.y),
          clamped(point.z, aabb.min.z, aabb.max.z)};
}

}  // namespace touchstone::reference
