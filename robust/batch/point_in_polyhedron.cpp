// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_polyhedron.h"

#include "geometry/validation.h"
#include "robust/batch/isa/faces.h"
#include "robust/batch/isa/run.h"
#include "robust/kernel/solids/closed_mesh.h"
#include "robust/polyhedra/point_in_polyhedron.h"

namespace touchstone::robust::batch {

/// The mesh is validated once, and twenty numbers for each face are kept until the call ends.
void point_in_polyhedron(const Meshd& mesh, const Points3& points, std::size_t count, std::uint8_t* answers,
                         Instructions at_most) {
  if (count == 0) return;
  validation::validate_numbers("mesh", mesh), kernel::validate_closed("mesh", mesh);
  const auto decide = [&](const Point3d& point) {
    validation::validate("point", point);
    return stages::point_in_polyhedron::of_valid(mesh, point).answer;
  };
  std::vector<double> faces;
  faces.reserve(isa::of_boxed_face * mesh.faces.size());
  for (const Face& face : mesh.faces) isa::add_boxed_face(mesh, face, faces);
  isa::run(isa::Which{&isa::Filters::point_in_solid, &isa::Filters::close_point_in_solid},
           isa::Shared{faces.data(), mesh.faces.size()}, at_most, decide, decide, count, answers, points);
}

}  // namespace touchstone::robust::batch
