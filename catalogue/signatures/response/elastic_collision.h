// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct elastic_collision {
  TOUCHSTONE_SIGNATURE(elastic_collision)
  using Question = std::tuple<Massesd, Velocitiesd, Vector3d>;
  using Answer = Velocities<double>;
};

}  // namespace touchstone::catalogue::signatures
