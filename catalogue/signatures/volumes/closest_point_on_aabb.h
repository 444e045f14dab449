// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct closest_point_on_aabb {
  template <class Real>
  using Answers = std::variant<Point2<Real>, Point3<Real>>;
  TOUCHSTONE_SIGNATURE_EITHER(closest_point_on_aabb)
  using InPlane = std::tuple<Point2d, Aabb2d>;
  using InSpace = std::tuple<Point3d, Aabb3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Answers<double>;
};

}  // namespace touchstone::catalogue::signatures
