// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct ray_aabb {
  TOUCHSTONE_SIGNATURE(ray_aabb)
  using InPlane = std::tuple<Ray2d, Aabb2d>;
  using InSpace = std::tuple<Ray3d, Aabb3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Passage<double>;
};

}  // namespace touchstone::catalogue::signatures
