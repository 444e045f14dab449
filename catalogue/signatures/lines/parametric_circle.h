// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct parametric_circle {
  TOUCHSTONE_SIGNATURE(parametric_circle)
  using Question = std::tuple<Circle2d, double>;
  using Answer = Point2<double>;
};

}  // namespace touchstone::catalogue::signatures
