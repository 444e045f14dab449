// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct segment_segment {
  TOUCHSTONE_SIGNATURE(segment_segment)
  using Question = std::tuple<Segment2d, Segment2d>;
  using Answer = SegmentSegment<double>;
};

}  // namespace touchstone::catalogue::signatures
