// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/lines/parametric_circle.h"

namespace touchstone::robust::stages {

/// There is no filter: a number has to be found.
struct parametric_circle {
  static Perhaps<Point2d> enclosed(const Circle2d& circle, double u);
  static Point2d exact(const Circle2d& circle, double u);
  static Decided<Point2d> ask(const Circle2d& circle, double u);
};

}  // namespace touchstone::robust::stages
