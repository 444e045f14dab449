// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct penalty_force {
  TOUCHSTONE_SIGNATURE(penalty_force)
  using Question = std::tuple<Point3d, Vector3d, Plane3d, double, double>;
  using Answer = Vector3<double>;
};

}  // namespace touchstone::catalogue::signatures
