// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/closest.h"

namespace touchstone::catalogue::signatures {

struct segment_segment_distance {
  template <class Real>
  using Answers = std::variant<ClosestPair2<Real>, ClosestPair3<Real>>;
  TOUCHSTONE_SIGNATURE_EITHER(segment_segment_distance)
  using InPlane = std::tuple<Segment2d, Segment2d>;
  using InSpace = std::tuple<Segment3d, Segment3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Answers<double>;
};

}  // namespace touchstone::catalogue::signatures
