// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct aabb_of_points {
  template <class Real>
  using Answers = std::variant<Aabb2<Real>, Aabb3<Real>>;
  TOUCHSTONE_SIGNATURE_EITHER(aabb_of_points)
  using InPlane = std::vector<Point2d>;
  using InSpace = std::vector<Point3d>;
  using Question = std::variant<std::tuple<InPlane>, std::tuple<InSpace>>;
  using Answer = Answers<double>;
};

}  // namespace touchstone::catalogue::signatures
