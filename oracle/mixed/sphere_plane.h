// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the point of the half-space that is nearest to the center, which is the center itself or the foot of its
/// perpendicular on the plane, and rational; the solids have a common point exactly if it is in the ball, and a common
/// interior point exactly if it is inside the ball, which then is no point.
///
/// Margin: |S - r^2|, S being the squared distance of the center from the half-space: 0 for a tangent ball, and for a
/// point in the half-space.
///
/// Certificate: disjoint: "nearest_point" (`point` of the half-space, farther than the radius). touching: "tangent"
/// (the nearest `point`, as far as the radius). overlapping: "common_interior_point" (`point`).
template <Exact Number = double>
Truth<Contact> sphere_plane(const Sphere3<Number>& sphere, const Plane<Number>& plane);

}  // namespace touchstone::oracle
