// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct explicit_line {
  TOUCHSTONE_SIGNATURE(explicit_line)
  using Question = std::tuple<double, double, Point2d>;
  using Answer = Height;
};

}  // namespace touchstone::catalogue::signatures
