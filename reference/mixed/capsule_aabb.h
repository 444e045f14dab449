// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/mixed/capsule_obb.h"
#include "reference/volumes/sphere_aabb.h"

namespace touchstone::reference {

template <class Real>
Point3<Real> nearest_to_aabb(const Segment3<Real>& segment, const Aabb3<Real>& aabb) {
  const Vector3<Real> way = segment.b - segment.a, low = aabb.min - segment.a, high = aabb.max - segment.a;
  return nearest_to_box<Real>(segment,
                              {Real(low.x / way.x), Real(high.x / way.x), Real(low.y / way.y), Real(high.y / way.y),
                               Real(low.z / way.z), Real(high.z / way.z)},
                              [&aabb](const Point3<Real>& p) { return closest_point_on_aabb(p, aabb); });
}

/// Decides whether a capsule and an axis-aligned box, as closed solids, overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula is that of capsule_obb in the frame of the axes: the point of the segment
/// where the slope of the squared distance from the box is 0, by p. 48-50's nearest point of the box; the ball around
/// it is compared with the box as in sphere_aabb.
/// capsule, aabb: any unit of length, the same for both. Shapes are closed: where one only reaches the other they are
/// `touching`. One within the other overlaps it. A radius of 0 (or -0) is valid: such a capsule is a segment; and so is
/// a segment of length 0: the capsule is a ball. min == max on an axis is valid: a flat box. Neither a segment nor a
/// flat box has an interior, and the truth is `touching` at most.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("capsule.segment[0][0]" ..., "finite
/// number"); a negative radius ("capsule.radius", "radius >= 0"); min > max ("aabb.max[0]" ..., "min <= max").
///
/// The formula assumes that the box has an interior. Where a flat box comes nearer to the segment than the radius it
/// answers `overlapping`, in exact arithmetic too (cause: algorithm). For all other boxes it is right in exact
/// arithmetic.
///
/// Rounding (binary64, to nearest, u = 2^-53): t is in [0, 1] by the contract of capsule_obb, so on each axis the point
/// of the segment is within 5u (|a| + |b|) + 2^-1074 of one of its points; let e be the sum of these. The nearest point
/// of the box is exact. So where the distance D of the segment from the box exceeds e + (1 + 8u) R + 2^-535, R being
/// the radius, the double version answers `disjoint`, and is right, unless something overflows. In the other direction
/// nothing is promised. No number is returned.
template <class Real>
Contact capsule_aabb(const Capsule3<Real>& capsule, const Aabb3<Real>& aabb) {
  return sphere_aabb(Sphere3<Real>{nearest_to_aabb(capsule.segment, aabb), capsule.radius}, aabb);
}

}  // namespace touchstone::reference
