// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// |axis . v|
template <class Real>
Real along_axis(const Vector3<Real>& axis, const Vector3<Real>& v) {
  const Real along = dot(axis, v);
  return along < Real(0) ? Real(Real(0) - along) : along;
}

/// The extent of a box along an axis from its center.
template <class Real>
Real reach_along(const Vector3<Real>& axis, const HalfAxes<Real>& h) {
  return Real(along_axis(axis, h.u) + along_axis(axis, h.v) + along_axis(axis, h.w));
}

/// Decides whether two oriented bounding boxes, as closed solids, overlap, only touch, or neither.
///
/// Deck p. 27: boxes in any orientation, given by center and half axes. Their test is that of separating axes: with d
/// the difference of the centers, two boxes are disjoint exactly if
///     |d . n| > sum |n . h|
/// over the half axes h of both, for an n among 15 axes: the half axes of a and of b, to which their faces are
/// perpendicular, and the cross products of a half axis of a and one of b. On equality, on which the slide is silent,
/// the formula answers `touching`, as the same test with >= is the one for boxes without their boundary.
/// a, b: any unit of length, the same for both. Each solid is closed: the points center + r u + s v + t w with r, s, t
/// in [-1, 1]. Common corners, edges and faces are `touching`, and so are two edges that cross. A box within another
/// overlaps it.
/// The half axes need not be at right angles: doubles seldom are, and any three independent ones make a solid, a
/// parallelepiped. The truth is that of these solids, however little the angles differ from right ones.
/// Refused by robust and oracle, the first that applies, a before b: NaN or infinity ("a.center[0]",
/// "a.half_axes[0][0]" ..., "finite number"); half axes that are linearly dependent, one of length zero among them
/// ("a.half_axes", "linearly independent").
///
/// The truth by axes: the differences of points of b and of a make the solid d + sum r_k h_k, -1 <= r_k <= 1, over the
/// half axes h_k of both. The boxes have a common point exactly if the origin is in it, a common interior point exactly
/// if it is in its interior. It is convex, and its faces are spanned by two half axes each that are not parallel: three
/// pairs of a, three of b, and nine of one of each. So it is what lies between two planes for every such pair, with
/// their cross product n as normal: disjoint where |d . n| exceeds the sum for one of the 15, otherwise touching where
/// it equals the sum for one, otherwise overlapping. An n that is zero, of parallel edges, spans no face and says
/// nothing: both sides are 0 there.
///
/// In exact arithmetic the formula is right where the half axes of each box are at right angles, so that they are the
/// normals of its faces, and no edge of one box is parallel to an edge of the other. Where boxes of right angles that
/// overlap have parallel edges, it answers `touching`, by the axis that is zero. Where half axes are not at right
/// angles, it tries other axes than the normals of faces. No axis at all separates boxes that meet, but on these boxes
/// that are disjoint may meet, and boxes that touch overlap (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): for an axis let P be the sum of the magnitudes of all products of
/// coordinates in d . n and in every n . h, two factors each or three, and S that of the coordinates of d and all h,
/// taken exactly. A product goes through a product and a difference in n, a difference in d, itself, two sums, and five
/// sums at most of magnitudes: both sides together are off by at most ((1 + u)^11 - 1) P < (11 + 56u) u P, and where
/// products underflow by 2^-1072 (S + 11) more; the comparison is exact. So where the two sides differ by more than
/// that on every axis, unless something overflows, the double version answers as exact arithmetic does. Parallel edges
/// are never that certain. No number is returned.
template <class Real>
Contact obb_obb(const Obb3<Real>& a, const Obb3<Real>& b) {
  const Vector3<Real> d = b.center - a.center;
  bool touching = false;
  const auto separates = [&](const Vector3<Real>& n) {
    const Real distance = along_axis(n, d), reach = Real(reach_along(n, a.half_axes) + reach_along(n, b.half_axes));
    if (distance == reach) touching = true;
    return distance > reach;
  };
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  for (const Vector3<Real>* n : {&u, &v, &w, &x, &y, &z})
    if (separates(*n)) return Contact::disjoint;
  for (const Vector3<Real>* of_a : {&u, &v, &w})
    for (const Vector3<Real>* of_b : {&x, &y, &z})
      if (separates(cross(*of_a, *of_b))) return Contact::disjoint;
  return touching ? Contact::touching : Contact::overlapping;
}

}  // namespace touchstone::reference
