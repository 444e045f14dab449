// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_convex_polygon.h"

#include "geometry/validation.h"
#include "robust/batch/isa/rows.h"
#include "robust/polygons/point_in_convex_polygon.h"

namespace touchstone::robust::batch {

void point_in_convex_polygon(const Polygon2d& polygon, const Points2& points, std::size_t count, std::uint8_t* answers,
                             Instructions) {
  if (count == 0) return;
  validation::validate_numbers("polygon", polygon), validation::validate("polygon", polygon);
  robust::point_in_convex_polygon(polygon, polygon[0]);
  decide_each([&](const Point2d& point) { return robust::point_in_convex_polygon(polygon, point); }, count, answers,
              points);
}

}  // namespace touchstone::robust::batch
