// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "reference/sweeps/swept_aabb_aabb.h"

namespace touchstone::reference {

/// Finds when an oriented box that moves along a straight line, without turning, first has a common point with one at
/// rest, by the times at which it enters and leaves the other on each of 15 axes.
///
/// No page of the deck asks this. The formula combines p. 27's boxes and axes of separation with p. 51's times (Eberly,
/// Dynamic Collision Detection using Oriented Bounding Boxes, 2008): with d leading from the center of a to that of b,
/// on the axis n the boxes overlap as long as
///     |n . d - t n . velocity| <= sum |n . h|
/// over the half axes h of both: between two times, always or never. The axes are the half axes of a and of b, to which
/// their faces are perpendicular, and the cross products of a half axis of a and one of b. `hit` with the latest of 0
/// and the entries, if that is not after 1 and all exits; otherwise `never`.
///
/// a moves, b rests. a, b: any unit of length, the same for both; velocity in that unit a step; t counts in steps.
/// Closed sets: touching is a hit, also where a only grazes b along a face, an edge or a corner, at t = 0 or at t = 1.
/// The truth is `hit` with t = 0 if the boxes have a common point at the start, otherwise with the first t in [0, 1]
/// where they have, or `never`. A velocity of 0 is valid. Each solid is that of obb_obb: the points center + r u + s v
/// + t w with r, s, t in [-1, 1], for any three independent half axes, at right angles or not. Refused by robust and
/// oracle: NaN or infinity ("a.center[0]", "a.half_axes[0][0]" ... "velocity[0]" ..., "finite number"); then half axes
/// that are linearly dependent, one of length zero among them, a before b ("a.half_axes", "linearly independent").
///
/// In exact arithmetic the formula is right where the half axes of each box are at right angles, parallel edges
/// included, as an axis that is zero says nothing. Where they are not, it tries other axes than the normals of faces:
/// then a hit may be answered that comes too early, or that there is not (cause: algorithm).
///
/// Margin: all displacements from points that a sweeps over to points of b are a solid, which has the origin in it if
/// they meet: the square of how far the origin is from the nearest plane of its faces, or, outside, beyond the
/// farthest. 0 for a step that only grazes, or ends or starts with a touch and goes no deeper.
///
/// Rounding: no bound is given. Axes of edges that are nearly parallel round to any direction, and no difference of two
/// times is certain on these. ulps: 23 roundings behind t (three in an axis, one in d; five in each of seven products
/// with it, of which two count; six in the sum; a difference, a quotient).
template <class Real>
FirstContact<Real> swept_obb_obb(const Obb3<Real>& a, const Obb3<Real>& b, const Vector3<Real>& velocity) {
  const Vector3<Real> d = b.center - a.center;
  const auto& [u, v, w] = a.half_axes;
  const auto& [x, y, z] = b.half_axes;
  CommonTime<Real> time;
  const std::array<const Vector3<Real>*, 6> half_axes{&u, &v, &w, &x, &y, &z};
  const auto cut = [&half_axes, &d, &velocity, &time](const Vector3<Real>& n) {
    Real reach(0);
    for (const Vector3<Real>* h : half_axes) {
      const Real along = dot(n, *h);
      reach = Real(reach + (along < Real(0) ? Real(-along) : along));
    }
    const Real height = dot(n, d);
    time.cut(Real(-reach), reach, height, height, Real(dot(n, velocity)));
  };
  for (const Vector3<Real>* n : half_axes) cut(*n);
  for (const Vector3<Real>* of_a : {&u, &v, &w})
    for (const Vector3<Real>* of_b : {&x, &y, &z}) cut(cross(*of_a, *of_b));
  return time.contact();
}

}  // namespace touchstone::reference
