// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/closest.h"

namespace touchstone::catalogue::signatures {

struct closest_point_on_obb : Signature<ClosestPoint3<double>(Point3d, Obb3d)> {
  TOUCHSTONE_SIGNATURE(closest_point_on_obb)
};

}  // namespace touchstone::catalogue::signatures
