// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/lines/implicit_circle.h"

namespace touchstone::robust::stages {

struct implicit_circle : detail::implicit_circle {
  static Perhaps<Location> lattice(const Circle2d& circle, const Point2d& point);
  static Location exact(const Circle2d& circle, const Point2d& point);
};

}  // namespace touchstone::robust::stages
