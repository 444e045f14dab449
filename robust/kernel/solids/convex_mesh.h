// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// Refuses every mesh that is not the surface of a convex solid, by the rules of
/// reference/polyhedra/point_in_convex_polyhedron.h. Returns the side of its faces' planes on which the outside lies: 1
/// if they are seen counter-clockwise from there, -1 if the mesh is inside out. `latest` becomes the later one of its
/// value and the last stage that any side needed.
int validate_convex(const std::string& field, const Meshd& mesh, Stage& latest);

/// The same, and whether the surface certainly goes around its inside once: faces may be there several times.
struct ConvexSurface {
  int outside;
  bool once;
};
ConvexSurface validate_convex_surface(const std::string& field, const Meshd& mesh, Stage& latest);

}  // namespace touchstone::robust::kernel
