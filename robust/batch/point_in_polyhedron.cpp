// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_polyhedron.h"

#include "geometry/validation.h"
#include "robust/batch/isa/rows.h"
#include "robust/kernel/closed_mesh.h"
#include "robust/polyhedra/point_in_polyhedron.h"

namespace touchstone::robust::batch {

/// The mesh is validated once; then every point looks at all faces.
void point_in_polyhedron(const Meshd& mesh, const Points3& points, std::size_t count, std::uint8_t* answers,
                         Instructions) {
  if (count == 0) return;
  validation::validate_numbers("mesh", mesh), kernel::validate_closed("mesh", mesh);
  const auto decide = [&](const Point3d& point) {
    validation::validate("point", point);
    return stages::point_in_polyhedron::of_valid(mesh, point).answer;
  };
  decide_each(decide, count, answers, points);
}

}  // namespace touchstone::robust::batch
