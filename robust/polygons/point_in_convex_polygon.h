// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/polygons/point_in_convex_polygon.h. Right for all finite doubles in every floating-point
/// environment.
///
/// Every call makes sure that the polygon is convex; each turn and each side is decided by the stages of `orientation`.
Location point_in_convex_polygon(const Polygon2d& polygon, const Point2d& point);

/// The same, and the last stage that any turn or side needed.
Location point_in_convex_polygon(const Polygon2d& polygon, const Point2d& point, Stage& decided);

}  // namespace touchstone::robust
