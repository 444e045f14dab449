// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/polygons.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/polygons/triangulate_polygon.h. Right for all finite doubles, and the same triangles in the same
/// order in every floating-point environment. One sweep over the plane (robust/rings/sweep.h) tells whether the polygon
/// is simple and cuts it up, in time n log n.
std::vector<std::vector<Index>> triangulate_polygon(const Polygon2d& polygon);

/// The same, and the latest stage that one of its decisions needed.
std::vector<std::vector<Index>> triangulate_polygon(const Polygon2d& polygon, Stage& decided);

}  // namespace touchstone::robust
