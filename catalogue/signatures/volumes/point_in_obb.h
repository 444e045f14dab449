// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_in_obb {
  TOUCHSTONE_SIGNATURE(point_in_obb)
  using Question = std::tuple<Obb3d, Point3d>;
  using Answer = Location;
};

}  // namespace touchstone::catalogue::signatures
