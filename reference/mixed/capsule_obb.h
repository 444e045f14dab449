// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "geometry/capsules.h"
#include "reference/volumes/sphere_obb.h"

namespace touchstone::reference {

/// The point of a segment that is nearest to a box. passes: the t at which a + t (b - a) passes the planes of faces;
/// nearest(p) is the point of the box that is nearest to p.
template <class Real, class Nearest>
Point3<Real> nearest_to_box(const Segment3<Real>& segment, const std::array<Real, 6>& passes, const Nearest& nearest) {
  const Vector3<Real> way = segment.b - segment.a;
  const auto at = [&](const Real& t) { return segment.a + t * way; };
  const auto slope = [&](const Real& t) { return Real(dot(way, at(t) - nearest(at(t)))); };
  Real low(0), high(1);
  for (const Real& t : passes)
    if (t > low && t < high) (slope(t) < Real(0) ? low : high) = t;
  const Real falling = slope(low), rising = slope(high);
  if (!(falling < Real(0))) return at(low);
  if (!(rising > Real(0))) return at(high);
  return at(Real(low + falling / (falling - rising) * (high - low)));
}
template <class Real>
Point3<Real> nearest_to_obb(const Segment3<Real>& segment, const Obb3<Real>& obb) {
  const Vector3<Real> way = segment.b - segment.a, d = segment.a - obb.center;
  const auto& [u, v, w] = obb.half_axes;
  const auto pass = [&](const Vector3<Real>& axis, const Real& side) {
    return Real((side * dot(axis, axis) - dot(d, axis)) / dot(way, axis));
  };
  const Real back(-1), on(1);
  return nearest_to_box<Real>(segment,
                              {pass(u, back), pass(u, on), pass(v, back), pass(v, on), pass(w, back), pass(w, on)},
                              [&obb](const Point3<Real>& p) { return nearest_in_obb(p, obb); });
}

/// Decides whether a capsule and an oriented box, as closed solids, overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula is that of ODE (dCollideCapsuleBox, dClosestLineBoxPoints):
/// on the segment a + t (b - a) the slope of the squared distance from the box grows with t, and linearly between the t
/// at which the segment passes a face's plane, -1 or 1 in p. 27's frame. With x the nearest point of the box to a point
/// p of the segment, it is twice (b - a) . (p - x). Where its sign changes between two of these t, it is interpolated.
/// The ball around the point where it is 0, or else around an end, is compared with the box as in sphere_obb.
/// capsule, obb: any unit of length, the same for both. Shapes are closed: where one only reaches the other they are
/// `touching`. One within the other overlaps it. A radius of 0 (or -0) is valid: such a capsule is a segment, which has
/// no interior, and the truth is `touching` at most. A segment of length 0 is valid: the capsule is a ball. The half
/// axes need not be at right angles: the truth is that of the parallelepiped that they span.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("capsule.segment[0][0]" ..., "finite
/// number"); a negative radius ("capsule.radius", "radius >= 0"); half axes that are linearly dependent
/// ("obb.half_axes", "linearly independent").
///
/// In exact arithmetic the formula is right where the half axes are at right angles (cause elsewhere: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): t is in [0, 1], as an interpolated one exceeds its upper end by less
/// than u, and rounds to 1 at most; coefficients are in [-1, 1]. So on each axis the point of the segment is within 5u
/// (|a| + |b|) + 2^-1074 of one of its points, and that of the box within 5u (|center| + |u| + |v| + |w|) + 2^-1073;
/// let e be the sum of these. As in capsule_capsule, where the distance D of the segment from the box exceeds e + (1 +
/// 8u) R + 2^-535, R being the radius, the double version answers `disjoint`, and is right, unless something overflows
/// or is divided by 0. In the other direction nothing is promised. No number is returned.
template <class Real>
Contact capsule_obb(const Capsule3<Real>& capsule, const Obb3<Real>& obb) {
  return sphere_obb(Sphere3<Real>{nearest_to_obb(capsule.segment, obb), capsule.radius}, obb);
}

}  // namespace touchstone::reference
