// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/mixed/ray_sphere.h"

namespace touchstone::reference {

template <class Real>
Passage<Real> passage_of_segment(const RootsOfSphere<Real>& roots) {
  const bool meets = roots.real && Real(0) <= roots.greater && roots.smaller <= Real(1);
  if (!meets) return {PassageRelation::none, std::nullopt, std::nullopt};
  return {PassageRelation::hit, roots.smaller < Real(0) ? Real(0) : roots.smaller,
          Real(1) < roots.greater ? Real(1) : roots.greater};
}

/// Finds where a closed segment enters and leaves a ball, or in the plane a disc, by the quadratic formula.
///
/// No page of the deck asks this. The formula is that of ray_sphere.h with v = b - a: `none` where the discriminant or
/// the greater root is negative, or the smaller root is above 1; otherwise `hit` from the smaller root, or 0 if that is
/// negative, to the greater, or 1 where that is above 1.
/// segment, sphere: any unit of length, the same for both; t is a pure number, 0 at a and 1 at b. Closed sets: the ends
/// and the boundary belong to them, so a tangent segment is a hit, with first = last. first is 0 if a is in the ball,
/// last is 1 where b is. The ball is solid: a segment within it is a hit from 0 to 1. A segment of length 0 is a point:
/// both are 0. Radius 0 (or -0) is a point.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so is a negative radius ("sphere.radius",
/// "radius >= 0").
///
/// In exact arithmetic the formula is right, except for a segment of length 0 in the ball: there it is 0/0, and answers
/// `none` (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): as in ray_sphere.h; the roundings of v are among those that
/// swept_sphere_sphere.h counts. `none` is also right where the smaller root is above 1 + e, `hit` only where it is
/// below
/// 1 - e. ulps: 27 roundings behind first and last.
template <class Real>
Passage<Real> segment_sphere(const Segment2<Real>& segment, const Circle2<Real>& sphere) {
  return passage_of_segment(RootsOfSphere<Real>(segment.a - sphere.center, segment.b - segment.a, sphere.radius));
}
template <class Real>
Passage<Real> segment_sphere(const Segment3<Real>& segment, const Sphere3<Real>& sphere) {
  return passage_of_segment(RootsOfSphere<Real>(segment.a - sphere.center, segment.b - segment.a, sphere.radius));
}

}  // namespace touchstone::reference
