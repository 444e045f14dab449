// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// Finds when a ball that moves along a straight line first has a common point with a plane, by the heights of its
/// center.
///
/// Deck p. 23, with p. 22's E(p) = N . p + d: a point comes down to the plane at t = E0 / (E0 - E1), a ball of radius r
/// earlier by r |N|:
///     t = (E0 - r |N|) / (E0 - E1),
/// with E1 - E0 = N . velocity. `hit` where that is in [0, 1], otherwise `never`. A ball behind the plane comes up to
/// it as one in front comes down: E with its sign turned. The plane is the thin closed set of points with N . p + d =
/// 0, not the half-space behind it: a ball wholly behind it does not touch it. sphere, plane: center, radius and d /
/// |N| in any unit of length, the same for all; velocity in that unit a step, of the ball, while the plane rests; t
/// counts in steps. N of any length but 0. Closed sets: touching is a hit, also where the ball only slides along the
/// plane. The truth is `hit` with t = 0 if ball and plane have a common point at the start, otherwise with the first t
/// in [0, 1] where they have: that t, in general a number with a square root. Radius 0 is a point; a velocity of 0 is
/// valid. NaN or infinity: refused by robust and oracle (field, "finite number"); so is a negative radius
/// ("sphere.radius", "radius >= 0") and N = 0 ("plane.normal", "nonzero normal").
///
/// The formula assumes that the ball starts off the plane. Where it does not, the t it finds is negative, that at which
/// the ball has left the plane, or 0/0, in exact arithmetic too (cause: algorithm).
///
/// Margin: with m the lesser of r^2 + H |H| and r^2 - L |L|, H and L being the greater and the lesser of the signed
/// distances of the center from the plane at the start and at the end: |m|, a difference of squared lengths. m is
/// negative exactly where ball and plane never meet. 0 if the ball just reaches the plane, or just leaves it.
///
/// Rounding (binary64, to nearest, u = 2^-53), where Q = N . N as computed is in [2^-960, 2^960]: E0 is off by e(E) of
/// point_plane.h, and S = N . velocity likewise by e(S) = (3 + 8u) u (|X| + |Y| + |Z|) + 2^-1073, X, Y, Z being its
/// products. r |N| is off by 5u of itself and 2^-1074, so that G = |E0| - r |N| is off by e(G) = e(E) + 6u r |N| + u
/// |G| + 2^-1073, and t by at most
///     e(t) = (e(G) + (1 + 2u) |t| e(S)) / (|S| - e(S)) + 2u |t| + 2^-1074
/// unless something overflows. Where G > e(G): `hit` is right, and t as good as that, where |S| > e(S) and e(t) < t < 1
/// - e(t); `never` is right where |S| > e(S) and t < 0 or t > 1 + e(t). ulps: 20 roundings behind t (six in E0; three
/// and two in Q, root, product; five in S; difference, quotient; sign changes are exact).
template <class Real>
FirstContact<Real> swept_sphere_plane(const Sphere3<Real>& sphere, const Vector3<Real>& velocity,
                                      const Plane<Real>& plane) {
  using std::sqrt;
  const Vector3<Real>& n = plane.normal;
  const Point3<Real>& c = sphere.center;
  const Real e = Real(dot(n, Vector3<Real>{c.x, c.y, c.z}) + plane.offset), rise = dot(n, velocity);
  const bool behind = e < Real(0);
  const Real reach = Real(sphere.radius * Real(sqrt(dot(n, n))));
  const Real t = Real(Real((behind ? Real(-e) : e) - reach) / (behind ? rise : Real(-rise)));
  if (Real(0) <= t && t <= Real(1)) return {HitRelation::hit, t};
  return {HitRelation::never, std::nullopt};
}

}  // namespace touchstone::reference
