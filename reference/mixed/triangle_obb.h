// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/volumes.h"
#include "reference/mixed/triangle_aabb.h"

namespace touchstone::reference {

/// The coordinates of a point in the frame of a box at right angles, its half axes as units.
template <class Real>
Point3<Real> in_frame(const Point3<Real>& p, const Obb3<Real>& obb) {
  const Vector3<Real> d = p - obb.center;
  const auto along = [&d](const Vector3<Real>& axis) { return Real(dot(d, axis) / dot(axis, axis)); };
  return {along(obb.half_axes.u), along(obb.half_axes.v), along(obb.half_axes.w)};
}

/// Decides whether a triangle and an oriented box overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula is that of PhysX (Gu::intersectTriangleBox): the corners of the triangle
/// in the frame of the box (p. 27), and there the test of triangle_aabb. Here the half axes are the frame's units, so
/// that the box reaches from -1 to 1 on each axis.
/// triangle, obb: any unit of length, the same for both. Closed sets: they meet where the triangle has a point of the
/// box, its boundary included. A triangle has no interior: `overlapping` where it has an interior point of the box,
/// `touching` where it has a point of the box and none of its interior. A triangle within the interior overlaps the
/// box; one in the plane of a face, however large, only touches it. A triangle without area is the segment or the point
/// that its corners span, and overlaps the box as any other does. The half axes need not be at right angles: the box is
/// the parallelepiped that they span, exactly.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("triangle[0][0]", "obb.center[0]" ...,
/// "finite number"); half axes that are linearly dependent, one of length zero among them ("obb.half_axes", "linearly
/// independent").
///
/// In exact arithmetic the formula is right where the half axes are at right angles, and triangle_aabb's formula is
/// right in their frame: where the triangle has an area, and no side of it is parallel to a half axis; and always where
/// they are at right angles and the truth is disjoint (cause elsewhere: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): the double version answers as triangle_aabb's does of the triangle that
/// the computed coordinates make, and the box from -1 to 1. Let d be the displacement of a corner from the center, h a
/// half axis, P the sum of the |d_k h_k|, and L = h . h, exactly. d . h as computed carries four roundings and is off
/// by (4 + 7u) u P + 2^-1073, h . h by (3 + 4u) u L where it is at least 2^-960. So a coordinate, their quotient, is
/// off by at most ((8 + 48u) u P + 2^-1072) / L + 2^-1075, unless something overflows. No number is returned.
template <class Real>
Contact triangle_obb(const Triangle3<Real>& triangle, const Obb3<Real>& obb) {
  const Real one(1), back(-1);
  return triangle_aabb<Real>({in_frame(triangle.a, obb), in_frame(triangle.b, obb), in_frame(triangle.c, obb)},
                             {{back, back, back}, {one, one, one}});
}

}  // namespace touchstone::reference
