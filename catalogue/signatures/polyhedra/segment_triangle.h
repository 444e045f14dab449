// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue::signatures {

struct segment_triangle {
  TOUCHSTONE_SIGNATURE(segment_triangle)
  using Question = std::tuple<Segment3d, Triangle3d>;
  using Answer = SegmentTriangle<double>;
};

}  // namespace touchstone::catalogue::signatures
