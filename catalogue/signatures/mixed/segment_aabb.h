// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct segment_aabb {
  TOUCHSTONE_SIGNATURE(segment_aabb)
  using InPlane = std::tuple<Segment2d, Aabb2d>;
  using InSpace = std::tuple<Segment3d, Aabb3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Passage<double>;
};

}  // namespace touchstone::catalogue::signatures
