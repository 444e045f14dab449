// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/closest.h"

namespace touchstone::catalogue::signatures {

struct closest_point_on_obb {
  TOUCHSTONE_SIGNATURE(closest_point_on_obb)
  using Question = std::tuple<Point3d, Obb3d>;
  using Answer = ClosestPoint3<double>;
};

}  // namespace touchstone::catalogue::signatures
