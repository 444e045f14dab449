// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct damped_reflection {
  TOUCHSTONE_SIGNATURE(damped_reflection)
  using Question = std::tuple<Vector3d, Vector3d, double>;
  using Answer = Vector3<double>;
};

}  // namespace touchstone::catalogue::signatures
