// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: a candidate for a common point has in each coordinate the greater of both minima. No common point has a
/// lesser coordinate, so the boxes meet exactly if the candidate satisfies all inequalities of both. They overlap
/// exactly if the middle between it and the lesser maxima satisfies all of them strictly. On integers.
///
/// Margin: a length, the magnitude of the least over the axes of min(a.max, b.max) - max(a.min, b.min). The boxes are
/// disjoint where this least difference is negative, overlapping where it is positive (it is at most the extent of
/// either box), touching where it is 0. If disjoint, it is the greatest gap: the distance of the boxes in the maximum
/// norm. If overlapping, it is how far one number has to move until a box is flat, or the common part of both is.
///
/// Certificate: disjoint: "separating_axis" (`axis` 0, 1 or 2; `value` between the boxes). overlapping:
/// "common_interior_point" (`point`). touching: a common `point`, and why there is no interior one: "supporting_axis"
/// (`axis` on which one box ends there and the other begins) or "flat_axis" (`axis` on which a box is flat).
template <Exact Number = double>
Truth<Contact> aabb_aabb(const Aabb2<Number>& a, const Aabb2<Number>& b);
template <Exact Number = double>
Truth<Contact> aabb_aabb(const Aabb3<Number>& a, const Aabb3<Number>& b);

}  // namespace touchstone::oracle
