// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct ray_segment {
  TOUCHSTONE_SIGNATURE(ray_segment)
  using Question = std::tuple<Ray2d, Segment2d>;
  using Answer = RaySegment<double>;
};

}  // namespace touchstone::catalogue::signatures
