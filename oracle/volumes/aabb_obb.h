// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: that of obb_obb by linear programming, the edges of the axis-aligned box being as long as that is wide, or 0;
/// a flat box that meets the other touches it.
///
/// Margin: that of obb_obb; and where they meet, the square of the width of the axis-aligned box on each axis, if that
/// is less: 0 for a flat one.
///
/// Certificate: disjoint: "separating_axis" (a `normal` along which all of the oriented box is beyond all of the
/// other). touching: "supporting_axis" (the same, but for a common point, and `coefficients` of the half axes, which
/// give that point); or "flat_axis" (`coefficients` and the `axis` on which the box is flat). overlapping:
/// "common_interior_point" (`coefficients`).
template <Exact Number = double>
Truth<Contact> aabb_obb(const Aabb3<Number>& aabb, const Obb3<Number>& obb);

}  // namespace touchstone::oracle
