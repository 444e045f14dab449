// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct reflect_wall : Signature<Vector3<double>(Vector3d, Axis)> {
  TOUCHSTONE_SIGNATURE(reflect_wall)
};

}  // namespace touchstone::catalogue::signatures
