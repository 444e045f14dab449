// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct reflect_plane {
  TOUCHSTONE_SIGNATURE(reflect_plane)
  using Question = std::tuple<Vector3d, Vector3d>;
  using Answer = Vector3<double>;
};

}  // namespace touchstone::catalogue::signatures
