// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct implicit_circle : Signature<Location(Circle2d, Point2d)> {
  TOUCHSTONE_SIGNATURE(implicit_circle)
};

}  // namespace touchstone::catalogue::signatures
