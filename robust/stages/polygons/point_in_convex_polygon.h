// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/polygons/point_in_convex_polygon.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed.
struct point_in_convex_polygon {
  static Decided<Location> ask(const Polygon2d& polygon, const Point2d& point);
};

}  // namespace touchstone::robust::stages
