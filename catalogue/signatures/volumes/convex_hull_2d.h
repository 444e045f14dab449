// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct convex_hull_2d {
  TOUCHSTONE_SIGNATURE(convex_hull_2d)
  using Points = std::vector<Point2d>;
  using Question = std::tuple<Points>;
  using Answer = ConvexHull2;
};

}  // namespace touchstone::catalogue::signatures
