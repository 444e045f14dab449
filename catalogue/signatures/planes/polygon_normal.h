// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct polygon_normal : Signature<PolygonNormal<double>(Polygon3d)> {
  TOUCHSTONE_SIGNATURE(polygon_normal)
};

}  // namespace touchstone::catalogue::signatures
