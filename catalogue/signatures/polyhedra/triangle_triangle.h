// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue::signatures {

struct triangle_triangle : Signature<TriangleTriangleRelation(Triangle3d, Triangle3d)> {
  TOUCHSTONE_SIGNATURE(triangle_triangle)
};

}  // namespace touchstone::catalogue::signatures
