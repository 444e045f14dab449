// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct ray_plane : Signature<LinePlane<double>(Ray3d, Plane3d)> {
  TOUCHSTONE_SIGNATURE(ray_plane)
};

}  // namespace touchstone::catalogue::signatures
