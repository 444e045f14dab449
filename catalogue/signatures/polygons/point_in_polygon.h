// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_in_polygon {
  TOUCHSTONE_SIGNATURE(point_in_polygon)
  using Question = std::tuple<Polygon2d, Point2d>;
  using Answer = Location;
};

}  // namespace touchstone::catalogue::signatures
