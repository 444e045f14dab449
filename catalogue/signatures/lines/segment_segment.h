// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct segment_segment : Signature<SegmentSegment<double>(Segment2d, Segment2d)> {
  TOUCHSTONE_SIGNATURE(segment_segment)
};

}  // namespace touchstone::catalogue::signatures
