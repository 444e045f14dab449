// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/point_in_convex_polyhedron.h"

#include "geometry/validation.h"
#include "robust/kernel/shapes/face_side.h"
#include "robust/kernel/solids/convex_mesh.h"
#include "robust/polyhedra/point_in_polyhedron.h"
#include "robust/prepared/solid.h"

namespace touchstone::robust {

Decided<Location> stages::point_in_convex_polyhedron::ask(const Meshd& mesh, const Point3d& point) {
  validation::validate_numbers("mesh", mesh), validation::validate("point", point);
  Stage latest = Stage::filter;
  const int outside = kernel::validate_convex("mesh", mesh, latest);
  const Location location = of_valid(mesh, point, outside).noting(latest);
  return {location, latest};
}

Decided<Location> stages::point_in_convex_polyhedron::of_valid(const Meshd& mesh, const Point3d& point, int outside) {
  Stage latest = Stage::filter;
  bool on = false;
  for (const Face& face : mesh.faces) {
    const int side = kernel::FaceSide(mesh, face).of(point).noting(latest);
    if (side == outside) return {Location::outside, latest};
    on = on || side == 0;
  }
  return {on ? Location::boundary : Location::inside, latest};
}

// A convex mesh is closed: the ray to +x meets few of its faces, and tells the inside by their number, if they are not
// there several times.
Location point_in_convex_polyhedron(const ConvexSolid& solid, const Point3d& point) {
  if (solid.once()) return point_in_polyhedron(solid, point);
  validation::validate_numbers("point", point);
  return stages::point_in_convex_polyhedron::of_valid(solid.mesh(), point, solid.outside()).answer;
}

Location point_in_convex_polyhedron(const Meshd& mesh, const Point3d& point) {
  return stages::point_in_convex_polyhedron::ask(mesh, point).answer;
}

}  // namespace touchstone::robust
