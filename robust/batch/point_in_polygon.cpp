// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_polygon.h"

#include "robust/batch/shapes/ring.h"
#include "robust/polygons/point_in_polygon.h"

namespace touchstone::robust::batch {

void point_in_polygon(const Polygon2d& polygon, const Points2& points, std::size_t count, std::uint8_t* answers,
                      const Limits& limits) {
  if (count == 0) return;
  validation::validate_numbers("polygon", polygon), validation::validate("polygon", polygon);
  isa::locate(&isa::Filters::point_in_ring, polygon, points, count, answers, limits);
}

void point_in_polygon(const Polygon& polygon, const Points2& points, std::size_t count, std::uint8_t* answers,
                      const Limits& limits) {
  const auto decide = [&](const Point2d& point) { return robust::point_in_polygon(polygon, point); };
  decide_each(limits, decide, count, answers, points);
}

}  // namespace touchstone::robust::batch
