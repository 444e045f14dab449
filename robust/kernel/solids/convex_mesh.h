// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/polyhedra.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust::kernel {

/// Refuses every mesh that is not the surface of a convex solid, by the rules of
/// reference/polyhedra/point_in_convex_polyhedron.h. Returns on which side of its faces' planes the outside is: 1 where
/// they are seen counter-clockwise, -1 if the mesh is turned inside out. `latest` becomes the later one of what it was
/// and the last stage that any side needed.
int validate_convex(const std::string& field, const Meshd& mesh, Stage& latest);

}  // namespace touchstone::robust::kernel
