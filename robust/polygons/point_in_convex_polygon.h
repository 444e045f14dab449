// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/strict_math.h"

namespace touchstone::robust {

/// Whether a point lies inside of a convex polygon, on its `boundary` or outside.
///
/// The polygon may run in either direction and have flat vertices. Every call makes sure that it is convex. Right for
/// all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field
/// and "finite number"; so do fewer than 3 vertices, and a polygon that is flat, not simple or not convex (with the
/// vertex). Contract: reference/polygons/point_in_convex_polygon.h.
Location point_in_convex_polygon(const Polygon2d& polygon, const Point2d& point);

}  // namespace touchstone::robust
