// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct swept_sphere_plane {
  TOUCHSTONE_SIGNATURE(swept_sphere_plane)
  using Question = std::tuple<Sphere3d, Vector3d, Plane3d>;
  using Answer = FirstContact<double>;
};

}  // namespace touchstone::catalogue::signatures
