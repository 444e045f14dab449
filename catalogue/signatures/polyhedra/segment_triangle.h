// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue::signatures {

struct segment_triangle : Signature<SegmentTriangle<double>(Segment3d, Triangle3d)> {
  TOUCHSTONE_SIGNATURE(segment_triangle)
};

}  // namespace touchstone::catalogue::signatures
