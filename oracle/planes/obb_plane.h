// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the heights N . p + d of all eight corners in rationals, of which the least is the least of the box, a convex
/// set; no half axis is asked on which side it leads down.
///
/// Margin: the square of the least height, h^2 / (N . N).
///
/// Certificate, `coefficients` of the half axes: disjoint: "lowest_point" (above which all of the box lies, and above
/// 0). touching: the same at 0. overlapping: "common_interior_point".
template <Exact Number = double>
Truth<Contact> obb_plane(const Obb3<Number>& obb, const Plane<Number>& plane);

}  // namespace touchstone::oracle
