// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/closest.h"

namespace touchstone::catalogue::signatures {

struct closest_point_on_segment {
  template <class Real>
  using Answers = std::variant<ClosestPoint2<Real>, ClosestPoint3<Real>>;
  TOUCHSTONE_SIGNATURE_EITHER(closest_point_on_segment)
  using InPlane = std::tuple<Point2d, Segment2d>;
  using InSpace = std::tuple<Point3d, Segment3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Answers<double>;
};

}  // namespace touchstone::catalogue::signatures
