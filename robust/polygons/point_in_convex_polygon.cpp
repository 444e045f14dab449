// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/point_in_convex_polygon.h"

#include "geometry/validation.h"
#include "robust/lines/orientation.h"
#include "robust/polygons/point_in_polygon.h"
#include "robust/prepared/polygon.h"
#include "robust/rings/convexity.h"

namespace touchstone::robust {

Decided<Location> stages::point_in_convex_polygon::ask(const Polygon2d& given, const Point2d& point) {
  validation::validate_all("polygon", given, "point", point);
  const validation::OpenRing open(given);
  const Polygon2d& polygon = *open;
  Stage latest = Stage::filter;
  const Side inner = validate_convex("polygon", polygon, latest);
  bool on = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Side side = orientation::ask(polygon[i], polygon.next(i), point).noting(latest);
    if (side == Side::on) on = true;
    else if (side != inner) return {Location::outside, latest};
  }
  return {on ? Location::boundary : Location::inside, latest};
}

Location point_in_convex_polygon(const Polygon2d& polygon, const Point2d& point) {
  return stages::point_in_convex_polygon::ask(polygon, point).answer;
}

// A convex polygon is a polygon: the ray to +x locates a point.
Location point_in_convex_polygon(const ConvexPolygon& polygon, const Point2d& point) {
  return point_in_polygon(polygon, point);
}

}  // namespace touchstone::robust
