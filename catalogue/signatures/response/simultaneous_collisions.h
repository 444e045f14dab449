// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/simultaneous.h"

namespace touchstone::catalogue::signatures {

struct simultaneous_collisions {
  TOUCHSTONE_SIGNATURE(simultaneous_collisions)
  using Question = std::tuple<std::vector<PointBodyd>, std::vector<BodyContactd>, double>;
  using Answer = SimultaneousVelocities<double>;
};

}  // namespace touchstone::catalogue::signatures
