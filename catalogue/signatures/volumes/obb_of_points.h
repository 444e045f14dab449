// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct obb_of_points {
  TOUCHSTONE_SIGNATURE(obb_of_points)
  using Points = std::vector<Point3d>;
  using Question = std::tuple<Points>;
  using Answer = Obb3<double>;
};

}  // namespace touchstone::catalogue::signatures
