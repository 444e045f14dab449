// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/volumes.h"
#include "robust/kernel/shapes/points_in_space.h"

/// Exact balls around points of space. Requires at least one point, all finite. The caller has set IEEE arithmetic
/// (control_word.h): filters here rely on rounding to nearest and on gradual underflow.
namespace touchstone::robust::kernel {

/// The greatest magnitude of a coordinate.
double greatest_coordinate(const std::vector<Point3d>& points);

/// The least double whose closed ball about the finite center contains every point; infinite if there is none.
double least_radius(const Point3d& center, const std::vector<Point3d>& points);

/// The smallest ball that contains every point: each coordinate of its center correctly rounded, and the least radius
/// about that.
Sphere3d smallest_ball(const std::vector<Point3d>& points);

}  // namespace touchstone::robust::kernel
