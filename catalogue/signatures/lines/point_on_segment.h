// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_on_segment : Signature<PointOnSegment<double>(Point2d, Segment2d)> {
  TOUCHSTONE_SIGNATURE(point_on_segment)
};

}  // namespace touchstone::catalogue::signatures
