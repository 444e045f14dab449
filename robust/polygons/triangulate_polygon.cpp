// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/triangulate_polygon.h"

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/rings/simple.h"
#include "robust/rings/sweep.h"

namespace touchstone::robust {

Decided<std::vector<std::vector<Index>>> stages::triangulate_polygon::ask(const Polygon2d& given) {
  validation::validate("polygon", given);
  const validation::OpenRing open(given);
  const Polygon2d& polygon = *open;
  {
    const kernel::ControlWord ieee;  // comparisons: flushed denormals would all be 0
    if (auto triangles = triangulated_by_sweep(polygon)) return *std::move(triangles);
  }
  validation::refuse("polygon", ring_defect(polygon).value(), polygon.size());
}

std::vector<std::vector<Index>> triangulate_polygon(const Polygon2d& polygon) {
  return stages::triangulate_polygon::ask(polygon).answer;
}

}  // namespace touchstone::robust
