// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/polyhedra/point_in_convex_polyhedron.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed.
struct point_in_convex_polyhedron {
  static Decided<Location> ask(const Meshd& mesh, const Point3d& point);
};

}  // namespace touchstone::robust::stages
