// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct segment_obb : Signature<Passage<double>(Segment3d, Obb3d)> {
  TOUCHSTONE_SIGNATURE(segment_obb)
};

}  // namespace touchstone::catalogue::signatures
