// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/convex_hull.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed.
struct convex_hull {
  static Decided<ConvexHull> ask(const std::vector<Point3d>& points);
};

}  // namespace touchstone::robust::stages
