// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/closest.h"

namespace touchstone::catalogue::signatures {

struct convex_distance {
  TOUCHSTONE_SIGNATURE(convex_distance)
  using Question = std::tuple<Meshd, Meshd>;
  using Answer = ConvexDistance<double>;
};

}  // namespace touchstone::catalogue::signatures
