// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct orientation {
  TOUCHSTONE_SIGNATURE(orientation)
  using Question = std::tuple<Point2d, Point2d, Point2d>;
  using Answer = Side;
};

}  // namespace touchstone::catalogue::signatures
