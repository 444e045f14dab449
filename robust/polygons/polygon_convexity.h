// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/polygons/polygon_convexity.h. Right for all finite doubles in every floating-point environment.
///
/// Each turn is decided by the stages of `orientation`. If no two turns differ in sign, the number of times that the
/// ring goes round tells convex from crossing, in linear time; only a ring that turns both ways is searched for edges
/// that meet.
PolygonConvexity polygon_convexity(const Polygon2d& polygon);

/// The same, and the last stage that any turn needed.
PolygonConvexity polygon_convexity(const Polygon2d& polygon, Stage& decided);

}  // namespace touchstone::robust
