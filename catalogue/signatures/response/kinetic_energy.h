// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct kinetic_energy {
  TOUCHSTONE_SIGNATURE(kinetic_energy)
  using Question = std::tuple<std::vector<Bodyd>>;
  using Answer = double;
};

}  // namespace touchstone::catalogue::signatures
