// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct ray_obb {
  TOUCHSTONE_SIGNATURE(ray_obb)
  using Question = std::tuple<Ray3d, Obb3d>;
  using Answer = Passage<double>;
};

}  // namespace touchstone::catalogue::signatures
