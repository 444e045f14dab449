// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_plane_toi : Signature<PointPlaneToi<double>(Plane3d, Point3d, Point3d)> {
  TOUCHSTONE_SIGNATURE(point_plane_toi)
};

}  // namespace touchstone::catalogue::signatures
