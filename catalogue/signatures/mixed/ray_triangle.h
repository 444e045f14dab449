// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_rays.h"
#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct ray_triangle {
  TOUCHSTONE_SIGNATURE(ray_triangle)
  using Question = std::tuple<Ray3d, Triangle3d>;
  using Answer = RayTriangle<double>;
};

}  // namespace touchstone::catalogue::signatures
