// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct implicit_circle {
  TOUCHSTONE_SIGNATURE(implicit_circle)
  using Question = std::tuple<Circle2d, Point2d>;
  using Answer = Location;
};

}  // namespace touchstone::catalogue::signatures
