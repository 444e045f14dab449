// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/closest.h"

namespace touchstone::catalogue::signatures {

struct convex_distance : Signature<ConvexDistance<double>(Meshd, Meshd)> {
  TOUCHSTONE_SIGNATURE(convex_distance)
};

}  // namespace touchstone::catalogue::signatures
