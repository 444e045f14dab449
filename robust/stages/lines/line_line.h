// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/staged.h"
#include "robust/lines/line_line.h"

namespace touchstone::robust::stages {

struct line_line {
  static Perhaps<LineLine<double>> enclosed(const Line2d& a, const Line2d& b);
  static Perhaps<LineLine<double>> lattice(const Line2d& a, const Line2d& b);
  static LineLine<double> exact(const Line2d& a, const Line2d& b);

  struct decision : detail::line_line_relation {
    static Perhaps<LineRelation> lattice(const Line2d& a, const Line2d& b);
    static LineRelation exact(const Line2d& a, const Line2d& b);
  };
};

}  // namespace touchstone::robust::stages
