// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/steps.h"

namespace touchstone::catalogue::signatures {

struct simulation_step {
  TOUCHSTONE_SIGNATURE(simulation_step)
  using Question = std::tuple<std::vector<StepBodyd>, std::vector<Plane3d>, StepSettingsd>;
  using Answer = NextState<double>;
};

}  // namespace touchstone::catalogue::signatures
