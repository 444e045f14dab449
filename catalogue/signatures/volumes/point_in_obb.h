// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_in_obb : Signature<Location(Obb3d, Point3d)> {
  TOUCHSTONE_SIGNATURE(point_in_obb)
};

}  // namespace touchstone::catalogue::signatures
