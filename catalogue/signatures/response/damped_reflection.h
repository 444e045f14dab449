// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct damped_reflection : Signature<Vector3<double>(Vector3d, Vector3d, double)> {
  TOUCHSTONE_SIGNATURE(damped_reflection)
};

}  // namespace touchstone::catalogue::signatures
