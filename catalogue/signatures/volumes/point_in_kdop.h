// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_in_kdop : Signature<Location(Kdop3d, Point3d)> {
  TOUCHSTONE_SIGNATURE(point_in_kdop)
};

}  // namespace touchstone::catalogue::signatures
