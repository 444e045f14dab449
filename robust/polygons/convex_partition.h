// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polygons.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/polygons/convex_partition.h. Right for all finite doubles, and the same pieces in the same order
/// in every floating-point environment; in time n log n.
std::vector<std::vector<Index>> convex_partition(const Polygon2d& polygon);

/// The same, and the latest stage that one of its decisions needed.
std::vector<std::vector<Index>> convex_partition(const Polygon2d& polygon, Stage& decided);

}  // namespace touchstone::robust
