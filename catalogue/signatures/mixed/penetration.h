// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/penetration.h"

namespace touchstone::catalogue::signatures {

struct penetration : Signature<Penetration<double>(Meshd, Meshd, double, double)> {
  TOUCHSTONE_SIGNATURE(penetration)
};

}  // namespace touchstone::catalogue::signatures
