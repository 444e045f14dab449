// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct segment_plane {
  TOUCHSTONE_SIGNATURE(segment_plane)
  using Question = std::tuple<Segment3d, Plane3d>;
  using Answer = LinePlane<double>;
};

}  // namespace touchstone::catalogue::signatures
