// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the heights N . p + d of all eight corners in rationals, of which the least is the least of the box, a convex
/// set; no sign of the normal is asked.
///
/// Margin: the square of the least height, h^2 / (N . N); and where they meet, of the width of the box on each axis, if
/// that is less: 0 for a box that only reaches the plane, and for a flat one that meets the half-space.
///
/// Certificate: disjoint: "lowest_point" (`point` of the box, above which all of the box lies, and above 0). touching:
/// the same at 0; or "flat_axis" (`point` of both, and the `axis` on which the box is flat). overlapping:
/// "common_interior_point" (`point`).
template <Exact Number = double>
Truth<Contact> aabb_plane(const Aabb3<Number>& aabb, const Plane<Number>& plane);

}  // namespace touchstone::oracle
