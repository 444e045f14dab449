// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust {

/// An oriented box that contains every one of the points exactly, by the doubles returned: point_in_obb says of none
/// that it is outside. Its half axes are linearly independent, also where the points are on one plane or line, or
/// equal: point_in_obb and obb_obb always take it.
///
/// The axes are those of the covariance of the points, at right angles but for roundings, and each face has a point
/// near it. It is not the smallest box; where numbers of such a box would be subnormal or beyond the range, it is
/// parallel to the axes. The same bits in every floating-point environment; 0 is 0.0. No points throw InvalidInput
/// ("points", "at least 1 point"); so do NaN and infinities ("points[0][1]" ..., "finite number"). Contract:
/// reference/volumes/obb_of_points.h.
Obb3d obb_of_points(const std::vector<Point3d>& points);

}  // namespace touchstone::robust
