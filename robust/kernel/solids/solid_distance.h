// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::kernel {

/// The distance of the convex hulls of two lists of vertices, with nearest points as convex_distance answers them. The
/// numbers are finite; no face is read.
ConvexDistance<double> distance_of_solids(const Meshd& a, const Meshd& b);

}  // namespace touchstone::robust::kernel
