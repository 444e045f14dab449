// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct segment_sphere {
  TOUCHSTONE_SIGNATURE(segment_sphere)
  using InPlane = std::tuple<Segment2d, Circle2d>;
  using InSpace = std::tuple<Segment3d, Sphere3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Passage<double>;
};

}  // namespace touchstone::catalogue::signatures
