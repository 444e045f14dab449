// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/penetration.h"

namespace touchstone::catalogue::signatures {

struct penetration {
  TOUCHSTONE_SIGNATURE(penetration)
  using Question = std::tuple<Meshd, Meshd, double, double>;
  using Answer = Penetration<double>;
};

}  // namespace touchstone::catalogue::signatures
