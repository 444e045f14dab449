// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_convex_polygon.h"

#include "robust/batch/shapes/ring.h"
#include "robust/batch/point_in_polygon.h"
#include "robust/polygons/point_in_convex_polygon.h"

namespace touchstone::robust::batch {

/// A convex polygon is a polygon: once convexity is established, the ray to +x locates a point.
void point_in_convex_polygon(const Polygon2d& polygon, const Points2& points, std::size_t count, std::uint8_t* answers,
                             const Limits& limits) {
  if (count == 0) return;
  validation::validate_numbers("polygon", polygon), validation::validate("polygon", polygon);
  robust::point_in_convex_polygon(polygon, polygon[0]);
  isa::locate(&isa::Filters::point_in_convex_ring, polygon, points, count, answers, limits);
}

void point_in_convex_polygon(const ConvexPolygon& polygon, const Points2& points, std::size_t count,
                             std::uint8_t* answers, const Limits& limits) {
  point_in_polygon(polygon, points, count, answers, limits);
}

}  // namespace touchstone::robust::batch
