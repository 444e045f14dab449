// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct explicit_line : Signature<Height(double, double, Point2d)> {
  TOUCHSTONE_SIGNATURE(explicit_line)
};

}  // namespace touchstone::catalogue::signatures
