// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/closest.h"

namespace touchstone::catalogue::signatures {

struct triangle_triangle_distance : Signature<ConvexDistance<double>(Triangle3d, Triangle3d)> {
  TOUCHSTONE_SIGNATURE(triangle_triangle_distance)
};

}  // namespace touchstone::catalogue::signatures
