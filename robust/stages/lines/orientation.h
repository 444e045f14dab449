// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/lines/orientation.h"

namespace touchstone::robust::stages {

struct orientation : detail::orientation {
  static Perhaps<Side> lattice(const Point2d& p0, const Point2d& p1, const Point2d& p);
  static Side exact(const Point2d& p0, const Point2d& p1, const Point2d& p);
};

}  // namespace touchstone::robust::stages
