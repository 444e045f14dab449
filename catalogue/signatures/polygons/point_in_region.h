// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_in_region : Signature<Location(Region2d, Point2d)> {
  TOUCHSTONE_SIGNATURE(point_in_region)
};

}  // namespace touchstone::catalogue::signatures
