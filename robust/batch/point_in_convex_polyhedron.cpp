// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/point_in_convex_polyhedron.h"

#include <vector>

#include "geometry/validation.h"
#include "robust/batch/shapes/linear_numbers.h"
#include "robust/batch/isa/run.h"
#include "robust/batch/point_in_polyhedron.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust::batch {

namespace {

/// If there are few faces, all are asked for many points at a time, and fifteen numbers of each are kept meanwhile.
void ask_all_faces(const Meshd& mesh, int outside, const Points3& points, std::size_t count, std::uint8_t* answers,
                   const Limits& limits) {
  std::vector<double> faces;
  faces.reserve(isa::of_face * mesh.faces.size());
  for (const Face& face : mesh.faces) isa::add_face(mesh, face, outside, faces);
  isa::add_planes(faces, isa::of_face, false);
  const auto decide = [&](const Point3d& point) {
    validation::validate("point", point);
    return stages::point_in_convex_polyhedron::of_valid(mesh, point, outside).answer;
  };
  isa::run(isa::Which{&isa::Filters::point_in_convex_solid, &isa::Filters::close_point_in_convex_solid},
           isa::Shared{faces.data(), mesh.faces.size()}, limits, decide, decide, count, answers, points);
}

}  // namespace

void point_in_convex_polyhedron(const Meshd& mesh, const Points3& points, std::size_t count, std::uint8_t* answers,
                                const Limits& limits) {
  if (count == 0) return;
  validation::validate_numbers("mesh", mesh);
  Stage latest = Stage::filter;
  const auto [outside, once] = kernel::validate_convex_surface("mesh", mesh, latest);
  if (once && mesh.faces.size() >= isa::many_faces)
    return point_in_polyhedron(Solid(Validated{}, mesh), points, count, answers, limits);
  ask_all_faces(mesh, outside, points, count, answers, limits);
}

void point_in_convex_polyhedron(const ConvexSolid& solid, const Points3& points, std::size_t count,
                                std::uint8_t* answers, const Limits& limits) {
  if (solid.once()) return point_in_polyhedron(solid, points, count, answers, limits);
  ask_all_faces(solid.mesh(), solid.outside(), points, count, answers, limits);
}

}  // namespace touchstone::robust::batch
