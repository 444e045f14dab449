// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct polygon_convexity : Signature<PolygonConvexity(Polygon2d)> {
  TOUCHSTONE_SIGNATURE(polygon_convexity)
};

}  // namespace touchstone::catalogue::signatures
