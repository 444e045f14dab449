// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct inelastic_collision : Signature<Vector3<double>(Massesd, Velocitiesd)> {
  TOUCHSTONE_SIGNATURE(inelastic_collision)
};

}  // namespace touchstone::catalogue::signatures
