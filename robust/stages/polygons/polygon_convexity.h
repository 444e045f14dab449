// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/polygons/polygon_convexity.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed.
struct polygon_convexity {
  static Decided<PolygonConvexity> ask(const Polygon2d& polygon);
};

}  // namespace touchstone::robust::stages
