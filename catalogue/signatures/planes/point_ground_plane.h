// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_ground_plane : Signature<Height(Point3d)> {
  TOUCHSTONE_SIGNATURE(point_ground_plane)
};

}  // namespace touchstone::catalogue::signatures
