// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct momentum : Signature<Vector3<double>(std::vector<Bodyd>)> {
  TOUCHSTONE_SIGNATURE(momentum)
};

}  // namespace touchstone::catalogue::signatures
