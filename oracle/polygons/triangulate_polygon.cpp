// SPDX-License-Identifier: Apache-2.0
#include "oracle/polygons/triangulate_polygon.h"

#include <utility>

#include "geometry/validation.h"

namespace touchstone::oracle {

template <Exact Number>
Truth<IndexLists> triangulate_polygon(const Polygon2<Number>& polygon) {
  IntegerRing ring = simple_ring(polygon);
  IndexLists triangles = triangulated(ring);
  return cut(std::move(ring), std::move(triangles));
}
template Truth<IndexLists> triangulate_polygon(const Polygon2d&);
template Truth<IndexLists> triangulate_polygon(const Polygon2<Rational>&);

std::string triangulate_polygon_defect(const Polygon2d& polygon, const IndexLists& triangles) {
  for (const auto& triangle : triangles) {
    if (triangle.size() != 3) return "not three vertices in a triangle";
  }
  // A vertex in the middle of a side takes half a turn away from the angles of the corners, and so one triangle from
  // the count.
  if (triangles.size() + 2 != (*validation::OpenRing(polygon)).size()) return "not n - 2 triangles";
  return partition_defect(polygon, triangles);
}

}  // namespace touchstone::oracle
