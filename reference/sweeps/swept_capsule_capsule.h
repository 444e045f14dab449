// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/capsules.h"
#include "reference/sweeps/swept_sphere_triangle.h"

namespace touchstone::reference {

/// Finds when a capsule that moves along a straight line, without turning, first has a common point with a capsule at
/// rest.
///
/// No page of the deck asks this. The formula makes of it a ball that moves towards a polygon: all displacements from
/// points of a's segment to points of b's make a parallelogram, as p. 51's differences of boxes make a box. Seen from
/// the first end of a's segment its corners are b.a, b.b, b.b - u and b.a - u, with u = a.b - a.a; the ball is around
/// that end, and its radius is the sum of both. The rest is the formula of swept_sphere_triangle, with p. 23's times
/// and roots, for the face, the four edges and the four corners.
///
/// a moves, b rests. a, b: any unit of length, the same for both; velocity in that unit a step; t counts in steps.
/// Closed sets: touching is a hit, also where the capsules only graze each other, slide along each other, or touch at
/// the start or at the end. The truth is `hit` with t = 0 if they have a common point at the start, otherwise with the
/// first t in [0, 1] where they have: that t, in general a number with a square root; or `never`. A segment of length
/// 0 is valid (a ball), so are parallel segments, radius 0 (a segment), and a velocity of 0. NaN or infinity: refused
/// by robust and oracle (field "a.segment[0][0]" ..., "finite number"); so is a negative radius ("a.radius",
/// "b.radius", "radius >= 0").
///
/// In exact arithmetic the formula is always right, as that of swept_sphere_triangle is: where segments are parallel,
/// or one has no length, the parallelogram is the segment or the point that its corners span.
///
/// Margin: |m - (r + s)^2|, m being the least squared distance of the segments during the step, r and s the radii; if
/// the segments meet, (r + s)^2 + d^2, d being the distance by which the path of a has to be moved until they do not. 0
/// if the capsules only graze each other, or touch at the end, or at the start and come no nearer.
///
/// Rounding: no bound is given. A rounded time may be over another part of the parallelogram than the exact one, and a
/// discriminant that cancels decides whether an edge is met. ulps: 63 roundings behind t (the 53 of
/// swept_sphere_triangle; three differences in u and in each of two corners, and the sum of the radii).
template <class Real>
FirstContact<Real> swept_capsule_capsule(const Capsule3<Real>& a, const Capsule3<Real>& b,
                                         const Vector3<Real>& velocity) {
  const auto& [c, d] = b.segment;
  const Vector3<Real> back = a.segment.a - a.segment.b;
  return ball_to_polygon<Real, 4>({a.segment.a, Real(a.radius + b.radius)}, velocity, {c, d, d + back, c + back});
}

}  // namespace touchstone::reference
