// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct reflect_plane : Signature<Vector3<double>(Vector3d, Vector3d)> {
  TOUCHSTONE_SIGNATURE(reflect_plane)
};

}  // namespace touchstone::catalogue::signatures
