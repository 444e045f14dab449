// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_plane : Signature<PointPlane<double>(Plane3d, Point3d)> {
  TOUCHSTONE_SIGNATURE(point_plane)
};

}  // namespace touchstone::catalogue::signatures
