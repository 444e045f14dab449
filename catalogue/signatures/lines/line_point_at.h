// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct line_point_at {
  TOUCHSTONE_SIGNATURE(line_point_at)
  using Question = std::tuple<ParametricLine2d, double>;
  using Answer = Point2<double>;
};

}  // namespace touchstone::catalogue::signatures
