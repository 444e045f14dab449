// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: by linear programming, how much both boxes have to grow around their centers, by one factor, until they have
/// a common point; less than 1: they overlap, 1: they touch, more: they are disjoint. On integers.
///
/// Margin: the differences of the points of both are a solid around the difference of the centers whose faces are
/// spanned by two half axes each, of one box or of both; it is the squared distance of the origin from the plane of a
/// face: overlapping, from the nearest (the shortest way that parts the boxes, squared); disjoint, from the farthest of
/// those that it lies beyond (so the boxes are no nearer than that).
///
/// Certificate: disjoint: "separating_axis" (`normal`). Otherwise a common point by its coefficients `on_a`, `on_b`;
/// overlapping: "common_interior_point"; touching: "supporting_axis" (`normal` on which the boxes have no more than a
/// point in common).
template <Exact Number = double>
Truth<Contact> obb_obb(const Obb3<Number>& a, const Obb3<Number>& b);

}  // namespace touchstone::oracle
