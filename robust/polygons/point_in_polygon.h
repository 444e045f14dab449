// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/polygons/point_in_polygon.h. Right for all finite doubles in every floating-point environment.
Location point_in_polygon(const Polygon2d& polygon, const Point2d& point);

/// The same, and which stage decided: the last one that an edge needed.
Location point_in_polygon(const Polygon2d& polygon, const Point2d& point, Stage& decided);

/// The stages; robust/kernel/stage.h says what each may expect and answer.
/// Knows only of points that are near to no line through an edge.
std::optional<Location> point_in_polygon_filter(const Polygon2d& polygon, const Point2d& point);
std::optional<Location> point_in_polygon_lattice(const Polygon2d& polygon, const Point2d& point);
Location point_in_polygon_exact(const Polygon2d& polygon, const Point2d& point);

}  // namespace touchstone::robust
