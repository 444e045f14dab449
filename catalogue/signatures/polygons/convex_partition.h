// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct convex_partition {
  TOUCHSTONE_SIGNATURE(convex_partition)
  using Question = std::tuple<Polygon2d>;
  using Answer = std::vector<std::vector<Index>>;
};

}  // namespace touchstone::catalogue::signatures
