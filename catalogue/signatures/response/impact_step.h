// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/impacts.h"

namespace touchstone::catalogue::signatures {

struct impact_step : Signature<ImpactStep<double>(std::vector<StepBodyd>, std::vector<Plane3d>, double, double)> {
  TOUCHSTONE_SIGNATURE(impact_step)
};

}  // namespace touchstone::catalogue::signatures
