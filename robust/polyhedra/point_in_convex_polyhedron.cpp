// SPDX-License-Identifier: Apache-2.0
#include "robust/polyhedra/point_in_convex_polyhedron.h"

#include "geometry/validation.h"
#include "robust/kernel/convex_mesh.h"
#include "robust/kernel/face_side.h"

namespace touchstone::robust {

Location point_in_convex_polyhedron(const Meshd& mesh, const Point3d& point, Stage& decided) {
  decided = Stage::filter;
  const int outside = kernel::validate_convex("mesh", mesh, decided);
  validation::validate("point", point);
  bool on = false;
  for (const Face& face : mesh.faces) {
    const int side = kernel::FaceSide(mesh, face).of(point, decided);
    if (side == outside) return Location::outside;
    on = on || side == 0;
  }
  return on ? Location::boundary : Location::inside;
}

Location point_in_convex_polyhedron(const Meshd& mesh, const Point3d& point) {
  Stage ignored;
  return point_in_convex_polyhedron(mesh, point, ignored);
}

}  // namespace touchstone::robust
