// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/mixed/ray_obb.h"

namespace touchstone::reference {

/// Finds where a closed segment enters and leaves an oriented box, by the times at which it is between opposite faces,
/// pair by pair.
///
/// No page of the deck asks this. The formula is that of ray_obb.h with v = b - a, and 1 among the exits. segment, obb:
/// any unit of length, the same for both; t is a pure number, 0 at a and 1 at b. Closed sets: the ends and the box's
/// boundary belong to them, so a segment that only grazes a face, an edge or a corner is a hit. first is 0 if a is in
/// the box, last is 1 where b is. A segment of length 0 is a point: both are 0. The half axes need not be at right
/// angles: the truth is that of the parallelepiped that they span.
/// Refused by robust and oracle, the first that applies: NaN or infinity ("segment[0][0]", "obb.half_axes[0][0]" ...,
/// "finite number"); half axes that are linearly dependent, one of length zero among them ("obb.half_axes", "linearly
/// independent").
///
/// In exact arithmetic the formula is right where the half axes are at right angles, except for a segment of length 0
/// in the box: it answers 1 for last. Where they are not at right angles, it takes other planes than those of the faces
/// (cause: algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): v is rounded as well, so that F is off by e(F) = (4 + 7u) u Q + 2^-1073.
/// All else is as in ray_obb.h, 1 being an exit that is exact. ulps: 23 roundings behind first and last.
template <class Real>
Passage<Real> segment_obb(const Segment3<Real>& segment, const Obb3<Real>& obb) {
  SlabTimes<Real> times{Real(0), Real(1)};
  cut_along_half_axes<Real>(times, segment.a - obb.center, segment.b - segment.a, obb.half_axes);
  return times.passage();
}

}  // namespace touchstone::reference
