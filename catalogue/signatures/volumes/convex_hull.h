// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct convex_hull {
  TOUCHSTONE_SIGNATURE(convex_hull)
  using Points = std::vector<Point3d>;
  using Question = std::tuple<Points>;
  using Answer = ConvexHull;
};

}  // namespace touchstone::catalogue::signatures
