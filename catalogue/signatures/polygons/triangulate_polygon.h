// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct triangulate_polygon {
  TOUCHSTONE_SIGNATURE(triangulate_polygon)
  using Question = std::tuple<Polygon2d>;
  using Answer = std::vector<std::vector<Index>>;
};

}  // namespace touchstone::catalogue::signatures
