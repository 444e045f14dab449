// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct interior_angles : Signature<std::vector<double>(Polygon2d)> {
  TOUCHSTONE_SIGNATURE(interior_angles)
};

}  // namespace touchstone::catalogue::signatures
