// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue::signatures {

struct triangle_triangle {
  TOUCHSTONE_SIGNATURE(triangle_triangle)
  using Question = std::tuple<Triangle3d, Triangle3d>;
  using Answer = TriangleTriangleRelation;
};

}  // namespace touchstone::catalogue::signatures
