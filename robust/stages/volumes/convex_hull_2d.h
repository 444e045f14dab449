// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/volumes/convex_hull_2d.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed.
struct convex_hull_2d {
  static Decided<ConvexHull2> ask(const std::vector<Point2d>& points);
};

}  // namespace touchstone::robust::stages
