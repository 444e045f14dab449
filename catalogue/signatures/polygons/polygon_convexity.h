// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct polygon_convexity {
  TOUCHSTONE_SIGNATURE(polygon_convexity)
  using Question = std::tuple<Polygon2d>;
  using Answer = PolygonConvexity;
};

}  // namespace touchstone::catalogue::signatures
