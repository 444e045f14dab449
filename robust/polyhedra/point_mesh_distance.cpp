// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/point_mesh_distance.h"

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/validation.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/shapes/surface_bounds.h"
#include "robust/kernel/solids/closed_mesh.h"
#include "robust/kernel/solids/nearest_of_faces.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust {
namespace {

/// All faces but those that are certainly farther than another.
std::vector<Index> faces_that_may_be_nearest(const Point3d& point, const Meshd& mesh,
                                             const structures::FaceTree& tree) {
  double least = std::numeric_limits<double>::infinity();
  std::vector<std::pair<double, Index>> met;
  tree.nearest(point, [&](Index face) {
    const auto& [a, b, c] = mesh.faces[face];
    const filters::SquareBounds square =
        filters::bounds_of_square(point, {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
    if (square.low <= least) met.emplace_back(square.low, face);
    return least = std::min(least, square.high);
  });
  std::vector<Index> faces;
  for (const auto& [low, face] : met)
    if (low <= least) faces.push_back(face);
  std::sort(faces.begin(), faces.end());
  return faces;
}

Decided<PointMeshDistance<double>> nearest_on_valid(const Point3d& given, const Meshd& mesh,
                                                    const structures::FaceTree& tree) {
  Stage latest = Stage::filter;
  const Location location = stages::point_in_polyhedron::of_tree(mesh, tree, given).noting(latest);
  const kernel::ControlWord guard;
  using kernel::processor::at_run_time;  // rounded after the control word is set
  const Point3d point{at_run_time(given.x), at_run_time(given.y), at_run_time(given.z)};
  PointMeshDistance<double> answer =
      kernel::nearest_of_faces(point, mesh, faces_that_may_be_nearest(point, mesh, tree), latest);
  answer.location = location;
  if (location == Location::inside && answer.distance > 0) answer.signed_distance = -answer.distance;
  return {answer, latest};
}

}  // namespace

Decided<PointMeshDistance<double>> stages::point_mesh_distance::ask(const Point3d& point, const Meshd& mesh) {
  validation::validate_numbers("point", point), validation::validate_numbers("mesh", mesh);
  kernel::validate_closed("mesh", mesh);
  return nearest_on_valid(point, mesh, structures::FaceTree(mesh));
}

PointMeshDistance<double> point_mesh_distance(const Point3d& point, const Meshd& mesh) {
  return stages::point_mesh_distance::ask(point, mesh).answer;
}

PointMeshDistance<double> point_mesh_distance(const Point3d& point, const Solid& solid) {
  validation::validate_numbers("point", point);
  return nearest_on_valid(point, solid.mesh(), solid.tree()).answer;
}

}  // namespace touchstone::robust
