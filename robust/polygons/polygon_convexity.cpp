// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/polygon_convexity.h"

#include "geometry/validation.h"
#include "robust/rings/convexity.h"

namespace touchstone::robust {

Decided<PolygonConvexity> stages::polygon_convexity::ask(const Polygon2d& polygon) {
  validation::validate("polygon", polygon);
  const validation::OpenRing open(polygon);
  return convexity(*open);
}

PolygonConvexity polygon_convexity(const Polygon2d& polygon) { return stages::polygon_convexity::ask(polygon).answer; }

}  // namespace touchstone::robust
