// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the point of the box that is nearest to the center, by the conditions of Karush, Kuhn and Tucker on each axis
/// (oracle/exact/numbers/nearest_in_interval.h); the solids have a common point exactly if it is in the ball. They have
/// a common interior point exactly if it is inside the ball, which then is no point, and the box is not flat: near it
/// there are interior points of the box. On integers.
///
/// Margin: with S the squared distance of the center from the box and R the square of the radius, S - R where they are
/// disjoint; otherwise the lesser of R - S and of the least squared extent of the box: 0 for a tangent ball, a point,
/// and a flat box that meets the ball.
///
/// Certificate: disjoint: "nearest_point" (`point` of the box, farther than the radius). overlapping:
/// "common_interior_point" (`point`). touching: a common `point`, and why there is no interior one: "tangent" (it is
/// the nearest point of the box, as far as the radius) or "flat_axis" (`axis` on which the box is flat).
template <Exact Number = double>
Truth<Contact> sphere_aabb(const Circle2<Number>& sphere, const Aabb2<Number>& aabb);
template <Exact Number = double>
Truth<Contact> sphere_aabb(const Sphere3<Number>& sphere, const Aabb3<Number>& aabb);

}  // namespace touchstone::oracle
