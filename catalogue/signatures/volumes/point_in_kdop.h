// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_in_kdop {
  TOUCHSTONE_SIGNATURE(point_in_kdop)
  using Question = std::tuple<Kdop3d, Point3d>;
  using Answer = Location;
};

}  // namespace touchstone::catalogue::signatures
