// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/point_in_convex_polygon.h"

#include <algorithm>

#include "geometry/validation.h"
#include "robust/lines/orientation.h"
#include "robust/polygons/polygon_convexity.h"
#include "robust/rings/simple.h"

namespace touchstone::robust {
namespace {

/// The side of the inside, for a polygon that is convex; others are refused.
Side validate_convex(const Polygon2d& polygon, Stage& decided) {
  const PolygonConvexity found = polygon_convexity(polygon, decided);
  const Side inner = found.orientation == Winding::ccw ? Side::left : Side::right;
  if (found.polygon_class == PolygonClass::convex) return inner;
  const auto defect = ring_defect(polygon);
  if (defect && (defect->first == defect->second || found.polygon_class == PolygonClass::not_simple))
    validation::refuse("polygon", *defect);
  if (found.polygon_class == PolygonClass::degenerate) validation::refuse_flat("polygon");
  for (std::size_t i = 0;; ++i) {
    const Side turn = orientation(polygon.previous(i), polygon[i], polygon.next(i));
    if (turn != inner && turn != Side::on) validation::refuse_reflex("polygon", i);
  }
}

}  // namespace

Location point_in_convex_polygon(const Polygon2d& polygon, const Point2d& point, Stage& decided) {
  validation::validate("polygon", polygon), validation::validate("point", point);
  const Side inner = validate_convex(polygon, decided);
  bool on = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    Stage stage;
    const Side side = orientation(polygon[i], polygon.next(i), point, stage);
    decided = std::max(decided, stage);
    if (side == Side::on) on = true;
    else if (side != inner) return Location::outside;
  }
  return on ? Location::boundary : Location::inside;
}

Location point_in_convex_polygon(const Polygon2d& polygon, const Point2d& point) {
  Stage ignored;
  return point_in_convex_polygon(polygon, point, ignored);
}

}  // namespace touchstone::robust
