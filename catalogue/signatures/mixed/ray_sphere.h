// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct ray_sphere {
  TOUCHSTONE_SIGNATURE(ray_sphere)
  using InPlane = std::tuple<Ray2d, Circle2d>;
  using InSpace = std::tuple<Ray3d, Sphere3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Passage<double>;
};

}  // namespace touchstone::catalogue::signatures
