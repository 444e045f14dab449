// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// The coefficient of the foot of the perpendicular on the line of a half axis, moved into [-1, 1].
template <class Real>
Real clamped_along(const Vector3<Real>& displacement, const Vector3<Real>& half_axis) {
  const Real t = Real(dot(displacement, half_axis) / dot(half_axis, half_axis));
  return t < Real(-1) ? Real(-1) : t > Real(1) ? Real(1) : t;
}

/// The point of a box with half axes at right angles that is nearest to p.
template <class Real>
Point3<Real> nearest_in_obb(const Point3<Real>& p, const Obb3<Real>& obb) {
  const auto& [u, v, w] = obb.half_axes;
  const Vector3<Real> d = p - obb.center;
  const Real r = clamped_along(d, u), s = clamped_along(d, v), t = clamped_along(d, w);
  return obb.center + (r * u + (s * v + t * w));
}

/// Decides whether a ball and an oriented box, as closed solids, overlap, only touch, or neither.
///
/// No page of the deck asks this. Engines combine two: p. 27's box, in whose frame the center has the coordinates
///     d . u / u . u
/// for each half axis u, d being the displacement from the center of the box; and p. 48-50's nearest point of a box,
/// to which each coordinate is moved into [-1, 1], and whose squared distance is compared with the square of the
/// radius. Equal squares are `touching`.
/// sphere, obb: any unit of length, the same for both. Shapes are closed: where the ball only reaches a face, an edge
/// or a corner they are `touching`. A ball within the box overlaps it, and so does a box within the ball. A radius of 0
/// (or -0) is valid: such a ball is a point, which has no interior, and the truth is `touching` at most. The half axes
/// need not be at right angles: any three independent ones make a solid, a parallelepiped, and the truth is that of
/// this solid.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("sphere.center[0]", "obb.half_axes[0][0]"
/// ..., "finite number"); a negative radius ("sphere.radius", "radius >= 0"); half axes that are linearly dependent,
/// one of length zero among them ("obb.half_axes", "linearly independent").
///
/// In exact arithmetic the formula is right where the half axes are at right angles. Otherwise the point that it takes
/// is in the box, but another may be nearer (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53), where every a . a as computed is at least 2^-960 and nothing overflows.
/// For a half axis a let P be the sum of |d_k a_k|. As in closest_point_on_segment, its coefficient is off by e(T) =
/// ((5 + 11u) u P + 2^-1073) / (a . a) + 7u. A product of it goes through itself and three sums: a coordinate X of the
/// point is off by e(X), the sum of (e(T) (1 + 6u) + 5u) |a_k| over the half axes, plus u |X| + 2^-1073. Let e be the
/// sum of these, S the squared distance of the point in exact arithmetic, D its root, and R the square of the radius.
/// So where |S - R| > 2 D e + e^2 + 6u (D + e)^2 + u R + 2^-1071, the double version answers as exact arithmetic does.
/// No number is returned.
template <class Real>
Contact sphere_obb(const Sphere3<Real>& sphere, const Obb3<Real>& obb) {
  const Vector3<Real> beyond = sphere.center - nearest_in_obb(sphere.center, obb);
  const Real distance = dot(beyond, beyond), squared_radius = Real(sphere.radius * sphere.radius);
  return distance > squared_radius   ? Contact::disjoint
         : distance < squared_radius ? Contact::overlapping
                                     : Contact::touching;
}

}  // namespace touchstone::reference
