// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/rays.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// The part of a line during which it is between the two sides of a box on every axis tested so far.
template <class Real>
struct SlabTimes {
  Real first = Real(0);
  std::optional<Real> last;
  bool between = true;

  void cut(const Real& from, const Real& displacement, const Real& min, const Real& max) {
    if (displacement == Real(0)) {
      between = between && min <= from && from <= max;
      return;
    }
    narrow(displacement, Real(Real(min - from) / displacement), Real(Real(max - from) / displacement));
  }

  /// Narrows by the times at which it is at either side.
  void narrow(const Real& displacement, const Real& to_min, const Real& to_max) {
    const bool forwards = Real(0) < displacement;
    const Real &entry = forwards ? to_min : to_max, &exit = forwards ? to_max : to_min;
    if (first < entry) first = entry;
    if (!last || exit < *last) last = exit;
  }

  Passage<Real> passage() const {
    if (between && last && first <= *last) return {PassageRelation::hit, first, last};
    return {PassageRelation::none, std::nullopt, std::nullopt};
  }
};

/// Finds where a ray enters and leaves an axis-aligned box, by the times at which it is between the box's sides on each
/// axis. In the plane and in space.
///
/// No page of the deck asks this. The formula is that of swept_aabb_aabb.h (p. 45-47, 51) for a point without an end:
/// on an axis with a direction v that is not 0 the ray is between the sides from (min - origin) / v to (max - origin) /
/// v, or in reverse order; on one with v = 0, all the time or never. `hit` from the latest of 0 and the entries to
/// the earliest exit, if that is not before; otherwise `none`.
/// ray, aabb: any unit of length, the same for both; t is in units of the direction's length. Closed sets: the origin
/// and the box's boundary belong to them, so a ray that only grazes a face, an edge or a corner is a hit. first is 0 if
/// the origin is in the box. A direction with a zero on some axes is no special case, and neither is -0. Flat boxes and
/// points are valid.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so are a direction of length 0
/// ("ray.direction", "nonzero direction") and min > max ("aabb.max[0]" ..., "min <= max"). first and last are infinite
/// if the exact ones are beyond the range of doubles.
///
/// In exact arithmetic the formula is always right.
///
/// Rounding (binary64, to nearest, u = 2^-53): a difference is off by u of itself, a quotient by u once more, and where
/// it underflows by 2^-1075. So unless something overflows, a time T as computed is off by at most e(T) = 3u |T| +
/// 2^-1074; rounding is monotone, so that an axis's exit stays behind its entry. 0 is exact, e(0) = 0. The relation is
/// right, and first and last as good as that, where every entry T, and 0, is more than e(T) + e(S) away from every exit
/// S of another axis. ulps: 2 roundings behind first and last.
template <class Real>
Passage<Real> ray_aabb(const Ray2<Real>& ray, const Aabb2<Real>& aabb) {
  const auto& [p, v] = ray;
  SlabTimes<Real> times;
  times.cut(p.x, v.x, aabb.min.x, aabb.max.x), times.cut(p.y, v.y, aabb.min.y, aabb.max.y);
  return times.passage();
}
template <class Real>
Passage<Real> ray_aabb(const Ray3<Real>& ray, const Aabb3<Real>& aabb) {
  const auto& [p, v] = ray;
  SlabTimes<Real> times;
  times.cut(p.x, v.x, aabb.min.x, aabb.max.x), times.cut(p.y, v.y, aabb.min.y, aabb.max.y);
  times.cut(p.z, v.z, aabb.min.z, aabb.max.z);
  return times.passage();
}

}  // namespace touchstone::reference
