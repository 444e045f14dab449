// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct parametric_circle : Signature<Point2<double>(Circle2d, double)> {
  TOUCHSTONE_SIGNATURE(parametric_circle)
};

}  // namespace touchstone::catalogue::signatures
