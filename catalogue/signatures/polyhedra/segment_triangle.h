// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_triangles.h"
#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct segment_triangle {
  TOUCHSTONE_SIGNATURE(segment_triangle)
  using Question = std::tuple<Segment3d, Triangle3d>;
  using Answer = SegmentTriangle<double>;
};

}  // namespace touchstone::catalogue::signatures
