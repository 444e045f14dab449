// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_polyhedron.h"

#include "geometry/validation.h"
#include "robust/batch/shapes/linear_numbers.h"
#include "robust/batch/isa/run.h"
#include "robust/kernel/solids/closed_mesh.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust::batch {

/// If there are few faces, all are asked for many points at a time, and twenty numbers of each are kept meanwhile.
void point_in_polyhedron(const Meshd& mesh, const Points3& points, std::size_t count, std::uint8_t* answers,
                         const Limits& limits) {
  if (count == 0) return;
  validation::validate_numbers("mesh", mesh), kernel::validate_closed("mesh", mesh);
  if (mesh.faces.size() >= isa::many_faces)
    return point_in_polyhedron(Solid(Validated{}, mesh), points, count, answers, limits);
  const auto decide = [&](const Point3d& point) {
    validation::validate("point", point);
    return stages::point_in_polyhedron::of_valid(mesh, point).answer;
  };
  std::vector<double> faces;
  faces.reserve(isa::of_boxed_face * mesh.faces.size());
  for (const Face& face : mesh.faces) isa::add_boxed_face(mesh, face, faces);
  isa::add_planes(faces, isa::of_boxed_face, true);
  isa::run(isa::Which{&isa::Filters::point_in_solid, &isa::Filters::close_point_in_solid},
           isa::Shared{faces.data(), mesh.faces.size()}, limits, decide, decide, count, answers, points);
}

void point_in_polyhedron(const Solid& solid, const Points3& points, std::size_t count, std::uint8_t* answers,
                         const Limits& limits) {
  const auto decide = [&](const Point3d& point) { return robust::point_in_polyhedron(solid, point); };
  decide_each(limits, decide, count, answers, points);
}

}  // namespace touchstone::robust::batch
