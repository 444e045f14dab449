// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct elastic_collision : Signature<Velocities<double>(Massesd, Velocitiesd, Vector3d)> {
  TOUCHSTONE_SIGNATURE(elastic_collision)
};

}  // namespace touchstone::catalogue::signatures
