// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/polygons/polygon_polygon.h"

namespace touchstone::robust::stages {

/// The latest stage that one of its decisions needed.
struct polygon_polygon {
  static Decided<Contact> ask(const Polygon2d& a, const Polygon2d& b);
};

}  // namespace touchstone::robust::stages
