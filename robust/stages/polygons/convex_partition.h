// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/polygons/convex_partition.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed.
struct convex_partition {
  static Decided<std::vector<std::vector<Index>>> ask(const Polygon2d& polygon);
};

}  // namespace touchstone::robust::stages
