// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct line_point_at : Signature<Point2<double>(ParametricLine2d, double)> {
  TOUCHSTONE_SIGNATURE(line_point_at)
};

}  // namespace touchstone::catalogue::signatures
