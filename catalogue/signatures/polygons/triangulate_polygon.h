// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct triangulate_polygon : Signature<std::vector<std::vector<Index>>(Polygon2d)> {
  TOUCHSTONE_SIGNATURE(triangulate_polygon)
};

}  // namespace touchstone::catalogue::signatures
