// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_plane {
  TOUCHSTONE_SIGNATURE(point_plane)
  using Question = std::tuple<Plane3d, Point3d>;
  using Answer = PointPlane<double>;
};

}  // namespace touchstone::catalogue::signatures
