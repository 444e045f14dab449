// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct swept_sphere_aabb {
  TOUCHSTONE_SIGNATURE(swept_sphere_aabb)
  using Question = std::tuple<Sphere3d, Vector3d, Aabb3d>;
  using Answer = FirstContact<double>;
};

}  // namespace touchstone::catalogue::signatures
