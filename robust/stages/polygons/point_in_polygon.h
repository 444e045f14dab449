// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/polygons/point_in_polygon.h"

namespace touchstone::robust::stages {

/// `ask` goes on past the filter part by part of the ring: the latest stage that a part needed.
struct point_in_polygon {
  /// Knows only of points that are near to no line through an edge.
  static Perhaps<Location> filter(const Polygon2d& polygon, const Point2d& point);
  static Perhaps<Location> lattice(const Polygon2d& polygon, const Point2d& point);
  static Location exact(const Polygon2d& polygon, const Point2d& point);
  static Decided<Location> ask(const Polygon2d& polygon, const Point2d& point);
};

}  // namespace touchstone::robust::stages
