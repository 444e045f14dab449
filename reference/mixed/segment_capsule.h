// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/mixed/ray_capsule.h"
#include "reference/mixed/segment_sphere.h"

namespace touchstone::reference {

/// Finds where a closed segment enters and leaves a capsule, by the quadratic formula for the balls around its ends and
/// for the cylinder between them.
///
/// No page of the deck asks this. The formula is that of ray_capsule.h with v = b - a: `none` where no root counts, the
/// greatest is negative, or the least is above 1; otherwise `hit` from the least, or 0 if that is negative, to the
/// greatest, or 1 where that is above 1.
/// segment, capsule: any unit of length, the same for both; t is a pure number, 0 at a and 1 at b. Closed sets: the
/// ends and the boundary belong to them, so a tangent segment is a hit, and so is one that slides along the cylinder.
/// first is 0 if a is in the capsule, last is 1 where b is. The capsule is solid: a segment within it is a hit from 0
/// to 1. A segment of length 0 is a point: both are 0. A capsule whose own segment has the length 0 is a ball; one of
/// the radius 0 (or -0) is a segment, or a point.
/// NaN or infinity: refused by robust and oracle ("segment[0][0]", "capsule.segment[0][0]" ..., "finite number"); so is
/// a negative radius ("capsule.radius", "radius >= 0").
///
/// In exact arithmetic the formula is right, except for a segment of length 0 in the capsule: there all roots are 0/0,
/// and it answers `none` (cause: algorithm).
///
/// Margin: |m - r^2|, m being the least squared distance of the segment from that of the capsule. 0 if the segment
/// only touches the capsule.
///
/// Rounding (binary64, to nearest, u = 2^-53): as in ray_capsule.h, with what segment_sphere.h promises of the balls.
/// ulps: 50 roundings behind first and last (one more, in v).
template <class Real>
Passage<Real> segment_capsule(const Segment3<Real>& segment, const Capsule3<Real>& capsule) {
  return passage_of_segment(roots_of_capsule(segment.a, segment.b - segment.a, capsule));
}

}  // namespace touchstone::reference
