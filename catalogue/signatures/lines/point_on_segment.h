// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_on_segment {
  TOUCHSTONE_SIGNATURE(point_on_segment)
  using Question = std::tuple<Point2d, Segment2d>;
  using Answer = PointOnSegment<double>;
};

}  // namespace touchstone::catalogue::signatures
