// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct ray_triangle : Signature<RayTriangle<double>(Ray3d, Triangle3d)> {
  TOUCHSTONE_SIGNATURE(ray_triangle)
};

}  // namespace touchstone::catalogue::signatures
