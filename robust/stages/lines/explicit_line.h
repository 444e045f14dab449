// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/lines/explicit_line.h"

namespace touchstone::robust::stages {

struct explicit_line : detail::explicit_line {
  static Perhaps<Height> lattice(double slope, double intercept, const Point2d& point);
  static Height exact(double slope, double intercept, const Point2d& point);
};

}  // namespace touchstone::robust::stages
