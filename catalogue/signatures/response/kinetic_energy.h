// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct kinetic_energy : Signature<double(std::vector<Bodyd>)> {
  TOUCHSTONE_SIGNATURE(kinetic_energy)
};

}  // namespace touchstone::catalogue::signatures
