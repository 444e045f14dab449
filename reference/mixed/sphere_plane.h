// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// Decides whether a ball and the half-space behind a plane, as closed solids, overlap, only touch, or neither.
///
/// No page of the deck asks this. The formula combines two: p. 22's E(p) = N . p + d, the height over the plane in
/// units of |N|, and p. 44's comparison of a distance with a radius. They are disjoint where the height of the center c
/// is
///     E(c) > r |N|,
/// and `touching` where it is equal.
/// The half-space is the set of points with N . p + d <= 0: the plane and its back, as point_plane has it; its front is
/// where N points to. sphere, plane: center, radius and d / |N| in any unit of length, the same for all; N of any
/// length but 0. Shapes are closed: a ball in front of the plane that only reaches it is `touching`. A ball within the
/// half-space overlaps it, touching the plane from behind or not.
/// A radius of 0 (or -0) is valid: such a ball is a point, which has no interior, and the truth is `touching` at most:
/// also where the point lies deep in the half-space.
/// NaN or infinity: refused by robust and oracle (field "sphere.center[0]", "plane.offset" ..., "finite number"); so
/// are a negative radius ("sphere.radius", "radius >= 0") and N = 0 ("plane.normal", "nonzero normal").
///
/// The formula assumes that the ball has an interior. For a point behind the plane it answers `overlapping`, in exact
/// arithmetic too (cause: algorithm). For all other balls it is right in exact arithmetic.
///
/// Rounding (binary64, to nearest, u = 2^-53), where Q = N . N as computed is in [2^-960, 2^960]: E is off by e(E) of
/// point_plane.h. Q is off by 3u of itself and 2^-114, its root by half of that and u, so that R = r |N| is off by less
/// than 5u of itself and 2^-1074. The comparison is exact. So where |E - R|, of E and R as computed, exceeds e(E) + 5u
/// R + 2^-1074, the double version answers as exact arithmetic does, unless something overflows. No number is returned.
template <class Real>
Contact sphere_plane(const Sphere3<Real>& sphere, const Plane<Real>& plane) {
  using std::sqrt;
  const Vector3<Real>& n = plane.normal;
  const Point3<Real>& c = sphere.center;
  const Real e = Real(dot(n, Vector3<Real>{c.x, c.y, c.z}) + plane.offset);
  const Real reach = Real(sphere.radius * Real(sqrt(dot(n, n))));
  return e > reach ? Contact::disjoint : e < reach ? Contact::overlapping : Contact::touching;
}

}  // namespace touchstone::reference
