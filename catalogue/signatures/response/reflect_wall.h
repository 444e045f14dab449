// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct reflect_wall {
  TOUCHSTONE_SIGNATURE(reflect_wall)
  using Question = std::tuple<Vector3d, Axis>;
  using Answer = Vector3<double>;
};

}  // namespace touchstone::catalogue::signatures
