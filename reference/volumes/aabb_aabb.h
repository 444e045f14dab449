// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <initializer_list>

#include "geometry/answers.h"
#include "geometry/volumes.h"

namespace touchstone::reference {

/// The intervals of two boxes on one axis.
template <class Real>
struct IntervalPair {
  const Real &a_min, &a_max, &b_min, &b_max;
};

/// Disjoint where one interval ends before the other begins on some axis; otherwise touching where one ends at the
/// other's beginning; otherwise overlapping.
template <class Real>
Contact contact_of_intervals(std::initializer_list<IntervalPair<Real>> axes) {
  for (const auto& [a_min, a_max, b_min, b_max] : axes)
    if (a_max < b_min || b_max < a_min) return Contact::disjoint;
  for (const auto& [a_min, a_max, b_min, b_max] : axes)
    if (a_max <= b_min || b_max <= a_min) return Contact::touching;
  return Contact::overlapping;
}

/// Decides whether two axis-aligned boxes, as closed solids, overlap, only touch, or neither. In the plane and in
/// space.
///
/// Deck p. 45-47: two boxes collide exactly if their intervals overlap on every axis; they are apart where on some axis
///     a.max < b.min or b.max < a.min.
/// The slide says no more. The same test with <= is the one for boxes without their boundary, so boxes that pass the
/// first and fail the second are `touching` here: on some axis a.max == b.min or
/// b.max == a.min.
/// a, b: any unit of length, the same for both. Shapes are closed, so a common corner, edge or face is `touching`.
/// min == max on an axis is valid: such a flat box has no interior, and the truth is `touching` at most. Two equal
/// points touch.
/// NaN or infinity: refused by robust and oracle (field "a.min[0]" ..., "finite number"); so is min > max (field
/// "a.max[0]" ..., "min <= max").
///
/// The test of boxes without their boundary assumes that they have an interior. Where a box is flat within the open
/// interval of the other, and nothing else touches, the formula answers `overlapping`, in exact arithmetic too (cause:
/// algorithm). For all other boxes it is right in exact arithmetic.
///
/// Rounding: none; comparisons are exact. So in every environment that does not read subnormals as zero the double
/// version is right for every two boxes that have an interior, and for all boxes where the margin is above 0. No number
/// is returned.
template <class Real>
Contact aabb_aabb(const Aabb2<Real>& a, const Aabb2<Real>& b) {
  return contact_of_intervals<Real>({{a.min.x, a.max.x, b.min.x, b.max.x}, {a.min.y, a.max.y, b.min.y, b.max.y}});
}
template <class Real>
Contact aabb_aabb(const Aabb3<Real>& a, const Aabb3<Real>& b) {
  return contact_of_intervals<Real>({{a.min.x, a.max.x, b.min.x, b.max.x},
                                     {a.min.y, a.max.y, b.min.y, b.max.y},
                                     {a.min.z, a.max.z, b.min.z, b.max.z}});
}

}  // namespace touchstone::reference
