// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/capsules.h"
#include "reference/sweeps/swept_sphere_plane.h"

namespace touchstone::reference {

/// Finds when a capsule that moves along a straight line, without turning, first has a common point with a plane, by
/// the ball around the end of its segment that is nearer to the plane. A capsule is the set of points no farther than
/// its radius from its segment.
///
/// No page of the deck asks this. The formula is p. 23's time for a ball (swept_sphere_plane.h), with p. 22's E(p) = N
/// . p + d: of the ball around the end a or b of the segment whose |E| is less, around a if both are equal. `hit` where
/// that time is in [0, 1], otherwise `never`. The plane is the thin closed set of points with N . p + d = 0, not the
/// half-space behind it: a capsule wholly behind it does not touch it. capsule, plane: ends, radius and d / |N| in any
/// unit of length, the same for all; velocity in that unit a step, of the capsule, while the plane rests; t counts in
/// steps. N of any length but 0. Closed sets: touching is a hit, also where the capsule only slides along the plane.
/// The truth is `hit` with t = 0 if capsule and plane have a common point at the start, also where the segment crosses
/// the plane, otherwise with the first t in [0, 1] where they have: that t, in general a number with a square root.
/// Radius 0 is a segment, a segment of length 0 a ball; a velocity of 0 is valid. Refused by robust and oracle, the
/// first that applies: NaN or infinity (field, "finite number"), a negative radius ("capsule.radius", "radius >= 0"), N
/// = 0 ("plane.normal", "nonzero normal").
///
/// The formula assumes that the capsule starts off the plane. Where it does not, the t it finds is that of a ball which
/// has left the plane, or which has not reached it while the rest of the capsule is in it, or 0/0, in exact arithmetic
/// too (cause: algorithm). Off the plane both ends are on one side of it and move alike, so the nearer one stays the
/// nearer one until the first contact, and is the first to meet the plane.
///
/// Margin: with m the lesser of r^2 + H |H| and r^2 - L |L|, H and L being the greatest and the least of the signed
/// distances of both ends from the plane at the start and at the end of the step: |m|, a difference of squared lengths.
/// m is negative exactly where capsule and plane never meet. 0 if the capsule just reaches the plane, or just leaves
/// it.
///
/// Rounding (binary64, to nearest): where |E(a)| and |E(b)| as computed differ by more than e(E) of both
/// (point_plane.h), and both E have one sign, which those bounds leave no choice, the nearer end is the right one, and
/// the contract of swept_sphere_plane holds for the ball around it. ulps: 20 roundings behind t, as there.
template <class Real>
FirstContact<Real> swept_capsule_plane(const Capsule3<Real>& capsule, const Vector3<Real>& velocity,
                                       const Plane<Real>& plane) {
  const auto distance = [&plane](const Point3<Real>& p) {
    const Real e = Real(dot(plane.normal, Vector3<Real>{p.x, p.y, p.z}) + plane.offset);
    return e < Real(0) ? Real(-e) : e;
  };
  const auto& [a, b] = capsule.segment;
  const Point3<Real>& nearer = distance(b) < distance(a) ? b : a;
  return swept_sphere_plane<Real>({nearer, capsule.radius}, velocity, plane);
}

}  // namespace touchstone::reference
