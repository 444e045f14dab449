// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/impacts.h"

namespace touchstone::catalogue::signatures {

struct impact_step {
  TOUCHSTONE_SIGNATURE(impact_step)
  using Question = std::tuple<std::vector<StepBodyd>, std::vector<Plane3d>, double, double>;
  using Answer = ImpactStep<double>;
};

}  // namespace touchstone::catalogue::signatures
