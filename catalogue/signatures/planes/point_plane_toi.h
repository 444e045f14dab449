// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_plane_toi {
  TOUCHSTONE_SIGNATURE(point_plane_toi)
  using Question = std::tuple<Plane3d, Point3d, Point3d>;
  using Answer = PointPlaneToi<double>;
};

}  // namespace touchstone::catalogue::signatures
