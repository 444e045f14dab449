// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct convex_partition : Signature<std::vector<std::vector<Index>>(Polygon2d)> {
  TOUCHSTONE_SIGNATURE(convex_partition)
};

}  // namespace touchstone::catalogue::signatures
