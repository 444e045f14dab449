// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/thin_shapes.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// The part of a step during which two boxes overlap on every axis tested so far.
template <class Real>
struct CommonTime {
  Real first = Real(0), last = Real(1);
  bool overlaps = true;

  void cut(const Real& a_min, const Real& a_max, const Real& b_min, const Real& b_max, const Real& velocity) {
    if (velocity == Real(0)) {
      overlaps = overlaps && a_min <= b_max && b_min <= a_max;
      return;
    }
    const Real to_near = Real(Real(b_min - a_max) / velocity), to_far = Real(Real(b_max - a_min) / velocity);
    const bool forwards = Real(0) < velocity;
    const Real &entry = forwards ? to_near : to_far, &exit = forwards ? to_far : to_near;
    if (first < entry) first = entry;
    if (exit < last) last = exit;
  }

  FirstContact<Real> contact() const {
    if (overlaps && first <= last) return {HitRelation::hit, first};
    return {HitRelation::never, std::nullopt};
  }
};

/// Finds when a moving axis-aligned box first has a common point with one at rest, by the times at which it enters and
/// leaves the other on each axis. In the plane and in space.
///
/// Deck p. 51, with p. 45-47's intervals: on an axis where a moves with velocity v, the intervals overlap between the
/// times
///     t1 = (b.min - a.max) / v,  t2 = (b.max - a.min) / v,
/// the lesser of which is the entry and the greater the exit; on an axis where it does not move, all the time or never.
/// The boxes overlap as long as they do on every axis: from the latest entry to the earliest exit. `hit` with the
/// latest of 0 and the entries, if that is not after 1 and all exits; otherwise `never`. a, b: any unit of length, the
/// same for both; velocity in that unit a step, of a, while b rests; t counts in steps. Closed sets: touching is a hit,
/// also where a only grazes b along a face, an edge or a corner, at t = 0 or at t = 1. The truth is `hit` with t = 0 if
/// the boxes have a common point at the start. Flat boxes and points are valid, and so is a velocity of 0, on an axis
/// or on all. NaN or infinity: refused by robust and oracle (field "a.min[0]" ... "velocity[0]" ..., "finite number");
/// so is min > max (field "a.max[0]" ..., "min <= max").
///
/// In exact arithmetic the formula is always right.
///
/// Margin: the distance by which a has to be moved, in the maximum norm, until the relation changes. 0 for a step that
/// only grazes, or ends or starts with a touch and goes no deeper; not where a flat box is entered.
///
/// Rounding (binary64, to nearest, u = 2^-53): a difference is off by u of itself, a quotient by u once more, and where
/// it underflows by 2^-1075. So unless a difference overflows, a time T as computed is off by at most e(T) = 3u |T| +
/// 2^-1074; rounding is monotone, so that an axis's exit stays behind its entry. 0 and 1 are exact, e(0) = e(1) = 0.
/// The relation is right, and t as good as that, where every entry T, and 0, is more than e(T) + e(S) away from every
/// exit S of another axis, and from 1. ulps: 2 roundings behind t.
template <class Real>
FirstContact<Real> swept_aabb_aabb(const Aabb2<Real>& a, const Aabb2<Real>& b, const Vector2<Real>& velocity) {
  CommonTime<Real> time;
  time.cut(a.min.x, a.max.x, b.min.x, b.max.x, velocity.x), time.cut(a.min.y, a.max.y, b.min.y, b.max.y, velocity.y);
  return time.contact();
}
template <class Real>
FirstContact<Real> swept_aabb_aabb(const Aabb3<Real>& a, const Aabb3<Real>& b, const Vector3<Real>& velocity) {
  CommonTime<Real> time;
  time.cut(a.min.x, a.max.x, b.min.x, b.max.x, velocity.x), time.cut(a.min.y, a.max.y, b.min.y, b.max.y, velocity.y);
  time.cut(a.min.z, a.max.z, b.min.z, b.max.z, velocity.z);
  return time.contact();
}

}  // namespace touchstone::reference
