// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// An oriented box of doubles that contains every one of the points exactly: point_in_obb finds none of them outside.
/// Its half axes are linearly independent, even if the points are coplanar, collinear or equal: point_in_obb and
/// obb_obb always accept it.
///
/// The axes are those of the covariance of the points, orthogonal up to rounding, and each face has a point near it. It
/// is not the smallest box; if numbers of such a box would be subnormal or beyond the range, it is axis-aligned. The
/// same bits in every floating-point environment; 0 is 0.0. An empty list throws InvalidInput ("points", "at least 1
/// point"); so do NaN and infinities ("points[0][1]" ..., "finite number"). Contract:
/// reference/volumes/obb_of_points.h.
Obb3d obb_of_points(const std::vector<Point3d>& points);

}  // namespace touchstone::robust
