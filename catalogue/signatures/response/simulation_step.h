// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/steps.h"

namespace touchstone::catalogue::signatures {

struct simulation_step : Signature<NextState<double>(std::vector<StepBodyd>, std::vector<Plane3d>, StepSettingsd)> {
  TOUCHSTONE_SIGNATURE(simulation_step)
};

}  // namespace touchstone::catalogue::signatures
