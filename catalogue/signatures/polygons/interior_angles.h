// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct interior_angles {
  TOUCHSTONE_SIGNATURE(interior_angles)
  using Question = std::tuple<Polygon2d>;
  using Answer = std::vector<double>;
};

}  // namespace touchstone::catalogue::signatures
