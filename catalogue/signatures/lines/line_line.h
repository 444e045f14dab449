// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct line_line {
  TOUCHSTONE_SIGNATURE(line_line)
  using Question = std::tuple<Line2d, Line2d>;
  using Answer = LineLine<double>;
};

}  // namespace touchstone::catalogue::signatures
