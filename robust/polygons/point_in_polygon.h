// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/strict_math.h"

namespace touchstone::robust {

/// Whether a point lies inside of a polygon, on its `boundary` or outside: a ray from it crosses the edges an odd
/// number of times, it lies on an edge, or neither.
///
/// Any closed ring in either direction: it may cross or touch itself, repeat vertices, or lie on one line. Right for
/// all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field
/// and "finite number"; so do fewer than 3 vertices. Contract: reference/polygons/point_in_polygon.h.
Location point_in_polygon(const Polygon2d& polygon, const Point2d& point);

}  // namespace touchstone::robust
