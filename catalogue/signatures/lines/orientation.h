// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct orientation : Signature<Side(Point2d, Point2d, Point2d)> {
  TOUCHSTONE_SIGNATURE(orientation)
};

}  // namespace touchstone::catalogue::signatures
