// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct ray_triangle {
  TOUCHSTONE_SIGNATURE(ray_triangle)
  using Question = std::tuple<Ray3d, Triangle3d>;
  using Answer = RayTriangle<double>;
};

}  // namespace touchstone::catalogue::signatures
