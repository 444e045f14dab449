// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/closest.h"

namespace touchstone::catalogue::signatures {

struct closest_point_on_triangle : Signature<ClosestPoint3<double>(Point3d, Triangle3d)> {
  TOUCHSTONE_SIGNATURE(closest_point_on_triangle)
};

}  // namespace touchstone::catalogue::signatures
