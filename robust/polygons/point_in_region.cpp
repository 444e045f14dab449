// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/point_in_region.h"

#include "geometry/validation.h"
#include "robust/polygons/point_in_polygon.h"
#include "robust/prepared/polygon.h"

namespace touchstone::robust {

Decided<Location> stages::point_in_region::ask(const Region2d& region, const Point2d& point) {
  validation::validate_numbers("region", region), validation::validate_numbers("point", point);
  return of_prepared(Region(region), point);
}

/// Holes are within the outer ring, and no two have a common inside: the first ring that the point is not beyond
/// decides.
Decided<Location> stages::point_in_region::of_prepared(const Region& region, const Point2d& point) {
  Stage latest = Stage::filter;
  const auto located = [&](const Polygon& ring) {
    return stages::point_in_polygon::of_prepared(ring, point).noting(latest);
  };
  Location found = located(region.rings()[0]);
  for (std::size_t i = 1; i < region.rings().size() && found == Location::inside; ++i) {
    const Location in_hole = located(region.rings()[i]);
    if (in_hole == Location::inside) found = Location::outside;
    if (in_hole == Location::boundary) found = Location::boundary;
  }
  return {found, latest};
}

Location point_in_region(const Region& region, const Point2d& point) {
  return stages::point_in_region::of_prepared(region, point).answer;
}

Location point_in_region(const Region2d& region, const Point2d& point) {
  return stages::point_in_region::ask(region, point).answer;
}

}  // namespace touchstone::robust
