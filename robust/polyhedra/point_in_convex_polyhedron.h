// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/polyhedra/point_in_convex_polyhedron.h. Right for all finite doubles in every floating-point
/// environment.
///
/// Every call makes sure that the mesh is closed and convex: faces times vertices sides of planes, nearly all by the
/// filter.
Location point_in_convex_polyhedron(const Meshd& mesh, const Point3d& point);

/// The same, and the last stage that any side needed.
Location point_in_convex_polyhedron(const Meshd& mesh, const Point3d& point, Stage& decided);

}  // namespace touchstone::robust
