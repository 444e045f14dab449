// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/lines/line_point_at.h"

namespace touchstone::robust::stages {

/// There is no filter: a number has to be found.
struct line_point_at {
  static Perhaps<Point2d> enclosed(const ParametricLine2d& line, double t);
  static Perhaps<Point2d> lattice(const ParametricLine2d& line, double t);
  static Point2d exact(const ParametricLine2d& line, double t);
  static Decided<Point2d> ask(const ParametricLine2d& line, double t);
};

}  // namespace touchstone::robust::stages
