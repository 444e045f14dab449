// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct momentum {
  TOUCHSTONE_SIGNATURE(momentum)
  using Question = std::tuple<std::vector<Bodyd>>;
  using Answer = Vector3<double>;
};

}  // namespace touchstone::catalogue::signatures
