// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct segment_plane : Signature<LinePlane<double>(Segment3d, Plane3d)> {
  TOUCHSTONE_SIGNATURE(segment_plane)
};

}  // namespace touchstone::catalogue::signatures
