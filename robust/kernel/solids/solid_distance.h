// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// The distance of the convex hulls of two lists of vertices, with the nearest points that convex_distance returns. The
/// numbers are finite; faces are not read.
ConvexDistance<double> distance_of_solids(const Meshd& a, const Meshd& b);

}  // namespace touchstone::robust::kernel
