// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"
#include "geometry/capsules.h"

namespace touchstone::reference {

/// Decides whether a capsule and the half-space behind a plane, as closed solids, overlap, only touch, or neither. A
/// capsule is the set of points no farther than its radius from its segment.
///
/// No page of the deck asks this. The formula is that of sphere_plane for the end of the segment that is lower, as
/// ODE's dCollideCapsulePlane takes the deepest of both caps: with p. 22's E(p) = N . p + d, the height over the plane
/// in units of |N|, they are disjoint where
///     min(E(a), E(b)) > r |N|,
/// and `touching` where both are equal.
/// The half-space is the set of points with N . p + d <= 0: the plane and its back, as point_plane has it; its front is
/// where N points to. capsule, plane: ends, radius and d / |N| in any unit of length, the same for all; N of any length
/// but 0. Shapes are closed: a capsule in front of the plane that only reaches it, with an end or along its side, is
/// `touching`. A capsule within the half-space overlaps it, touching the plane from behind or not.
/// A radius of 0 (or -0) is valid: such a capsule is a segment, which has no interior, and the truth is `touching` at
/// most: also where the segment crosses the plane or lies deep in the half-space. A segment of length 0 is valid: the
/// capsule is a ball.
/// NaN or infinity: refused by robust and oracle (field "capsule.segment[0][0]", "plane.offset" ..., "finite number");
/// so are a negative radius ("capsule.radius", "radius >= 0") and N = 0 ("plane.normal", "nonzero normal").
///
/// The formula assumes that the capsule has an interior. For a segment that reaches behind the plane it answers
/// `overlapping`, in exact arithmetic too (cause: algorithm). For all other capsules it is right in exact arithmetic.
///
/// Rounding (binary64, to nearest): by the contract of sphere_plane, where Q = N . N as computed is in [2^-960, 2^960]
/// and for both ends |E - R|, of E and R = r |N| as computed, exceeds e(E) + 5u R + 2^-1074, the double version answers
/// as exact arithmetic does, unless something overflows. No number is returned.
template <class Real>
Contact capsule_plane(const Capsule3<Real>& capsule, const Plane<Real>& plane) {
  using std::sqrt;
  const Vector3<Real>& n = plane.normal;
  const auto height = [&](const Point3<Real>& p) { return Real(dot(n, Vector3<Real>{p.x, p.y, p.z}) + plane.offset); };
  const Real at_a = height(capsule.segment.a), at_b = height(capsule.segment.b),
             reach = Real(capsule.radius * Real(sqrt(dot(n, n))));
  const Real& e = at_b < at_a ? at_b : at_a;
  return e > reach ? Contact::disjoint : e < reach ? Contact::overlapping : Contact::touching;
}

}  // namespace touchstone::reference
