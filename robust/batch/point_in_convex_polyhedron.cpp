// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_convex_polyhedron.h"

#include <vector>

#include "geometry/validation.h"
#include "robust/batch/isa/faces.h"
#include "robust/batch/isa/run.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"

namespace touchstone::robust::batch {

/// The mesh is validated once, and fifteen numbers for each face are kept until the call ends.
void point_in_convex_polyhedron(const Meshd& mesh, const Points3& points, std::size_t count, std::uint8_t* answers,
                                Instructions at_most) {
  if (count == 0) return;
  validation::validate_numbers("mesh", mesh);
  Stage latest = Stage::filter;
  const int outside = kernel::validate_convex("mesh", mesh, latest);
  std::vector<double> faces;
  faces.reserve(isa::of_face * mesh.faces.size());
  for (const Face& face : mesh.faces) isa::add_face(mesh, face, outside, faces);
  const auto decide = [&](const Point3d& point) {
    validation::validate("point", point);
    return stages::point_in_convex_polyhedron::of_valid(mesh, point, outside).answer;
  };
  isa::run(isa::Which{&isa::Filters::point_in_convex_solid, &isa::Filters::close_point_in_convex_solid},
           isa::Shared{faces.data(), mesh.faces.size()}, at_most, decide, decide, count, answers, points);
}

}  // namespace touchstone::robust::batch
