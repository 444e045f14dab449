// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/simultaneous.h"

namespace touchstone::catalogue::signatures {

struct simultaneous_collisions
    : Signature<SimultaneousVelocities<double>(std::vector<PointBodyd>, std::vector<BodyContactd>, double)> {
  TOUCHSTONE_SIGNATURE(simultaneous_collisions)
};

}  // namespace touchstone::catalogue::signatures
