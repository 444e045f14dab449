// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// Decides whether an axis-aligned box and the half-space behind a plane, as closed solids, overlap, only touch, or
/// neither.
///
/// No page of the deck asks this. The formula combines two: p. 45-47's box, min and max on each axis, and p. 22's
///     E(p) = N . p + d,
/// the height over the plane in units of |N|. E is least at the corner that takes min where the normal's coordinate is
/// not negative, and max where it is: they are disjoint where E of that corner is greater than 0, and `touching` where
/// it is 0.
/// The half-space is the set of points with N . p + d <= 0: the plane and its back, as point_plane has it; its front is
/// where N points to. aabb, plane: corners and d / |N| in any unit of length, the same for both; N of any length but 0.
/// Shapes are closed: a box in front of the plane that only reaches it with a corner, an edge or a face is `touching`.
/// A box within the half-space overlaps it, touching the plane from behind or not.
/// min == max on an axis is valid: such a box is flat and has no interior, and the truth is `touching` at most: also
/// where the box lies deep in the half-space.
/// NaN or infinity: refused by robust and oracle (field "aabb.min[0]", "plane.offset" ..., "finite number"); so are min
/// > max ("aabb.max[0]" ..., "min <= max") and N = 0 ("plane.normal", "nonzero normal").
///
/// The formula assumes that the box has an interior. For a flat box that reaches behind the plane it answers
/// `overlapping`, in exact arithmetic too (cause: algorithm). For all other boxes it is right in exact arithmetic.
///
/// Rounding (binary64, to nearest): the corner is exact. Its E, as computed, is off by at most e(E) of point_plane.h,
/// and the comparison is exact. So where |E| exceeds e(E), the double version answers as exact arithmetic does, unless
/// something overflows. No number is returned.
template <class Real>
Contact aabb_plane(const Aabb3<Real>& aabb, const Plane<Real>& plane) {
  const Vector3<Real>& n = plane.normal;
  const auto& [min, max] = aabb;
  const Vector3<Real> lowest{n.x < Real(0) ? max.x : min.x, n.y < Real(0) ? max.y : min.y,
                             n.z < Real(0) ? max.z : min.z};
  const Real e = Real(dot(n, lowest) + plane.offset);
  return e > Real(0) ? Contact::disjoint : e < Real(0) ? Contact::overlapping : Contact::touching;
}

}  // namespace touchstone::reference
