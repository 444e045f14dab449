// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct restitution_collision : Signature<Velocities<double>(Massesd, Velocitiesd, Vector3d, double)> {
  TOUCHSTONE_SIGNATURE(restitution_collision)
};

}  // namespace touchstone::catalogue::signatures
