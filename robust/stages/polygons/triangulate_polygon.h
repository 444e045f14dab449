// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/polygons/triangulate_polygon.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed.
struct triangulate_polygon {
  static Decided<std::vector<std::vector<Index>>> ask(const Polygon2d& polygon);
};

}  // namespace touchstone::robust::stages
