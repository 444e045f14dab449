// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "reference/mixed/ray_aabb.h"

namespace touchstone::reference {

/// Finds where a closed segment enters and leaves an axis-aligned box, by the times at which it is between the box's
/// sides on each axis. In the plane and in space.
///
/// No page of the deck asks this. The formula is that of ray_aabb.h with v = b - a, and 1 among the exits. segment,
/// aabb: any unit of length, the same for both; t is a pure number, 0 at a and 1 at b. Closed sets: the ends and the
/// box's boundary belong to them, so a segment that only grazes a face, an edge or a corner is a hit. first is 0 if a
/// is in the box, last is 1 where b is. A segment of length 0 is a point: both are 0. Flat boxes and points are valid.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so is min > max ("aabb.max[0]" ..., "min <=
/// max").
///
/// In exact arithmetic the formula is right, except for a segment of length 0 in the box: it answers 1 for last (cause:
/// algorithm).
///
/// Rounding (binary64, to nearest, u = 2^-53): v is rounded as well, so that unless something overflows, a time T as
/// computed is off by at most e(T) = 4u |T| + 2^-1073. 0 and 1 are exact. The relation is right, and first and last as
/// good as that, where every entry T, and 0, is more than e(T) + e(S) away from every exit S of another axis, and from
/// 1.
/// ulps: 3 roundings behind first and last.
template <class Real>
Passage<Real> segment_aabb(const Segment2<Real>& segment, const Aabb2<Real>& aabb) {
  const auto& [a, b] = segment;
  SlabTimes<Real> times{Real(0), Real(1)};
  times.cut(a.x, Real(b.x - a.x), aabb.min.x, aabb.max.x), times.cut(a.y, Real(b.y - a.y), aabb.min.y, aabb.max.y);
  return times.passage();
}
template <class Real>
Passage<Real> segment_aabb(const Segment3<Real>& segment, const Aabb3<Real>& aabb) {
  const auto& [a, b] = segment;
  SlabTimes<Real> times{Real(0), Real(1)};
  times.cut(a.x, Real(b.x - a.x), aabb.min.x, aabb.max.x), times.cut(a.y, Real(b.y - a.y), aabb.min.y, aabb.max.y);
  times.cut(a.z, Real(b.z - a.z), aabb.min.z, aabb.max.z);
  return times.passage();
}

}  // namespace touchstone::reference
