// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_polyhedron.h"

#include "geometry/validation.h"
#include "robust/batch/isa/rows.h"
#include "robust/polyhedra/point_in_polyhedron.h"

namespace touchstone::robust::batch {

void point_in_polyhedron(const Meshd& mesh, const Points3& points, std::size_t count, std::uint8_t* answers,
                         Instructions) {
  if (count == 0) return;
  validation::validate_numbers("mesh", mesh);
  robust::point_in_polyhedron(mesh, {0, 0, 0});
  decide_each([&](const Point3d& point) { return robust::point_in_polyhedron(mesh, point); }, count, answers, points);
}

}  // namespace touchstone::robust::batch
