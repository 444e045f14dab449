// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct polygon_normal {
  TOUCHSTONE_SIGNATURE(polygon_normal)
  using Question = std::tuple<Polygon3d>;
  using Answer = PolygonNormal<double>;
};

}  // namespace touchstone::catalogue::signatures
