// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct ray_segment : Signature<RaySegment<double>(Ray2d, Segment2d)> {
  TOUCHSTONE_SIGNATURE(ray_segment)
};

}  // namespace touchstone::catalogue::signatures
