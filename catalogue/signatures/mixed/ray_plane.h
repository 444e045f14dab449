// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct ray_plane {
  TOUCHSTONE_SIGNATURE(ray_plane)
  using Question = std::tuple<Ray3d, Plane3d>;
  using Answer = LinePlane<double>;
};

}  // namespace touchstone::catalogue::signatures
