// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_ground_plane {
  TOUCHSTONE_SIGNATURE(point_ground_plane)
  using Question = std::tuple<Point3d>;
  using Answer = Height;
};

}  // namespace touchstone::catalogue::signatures
