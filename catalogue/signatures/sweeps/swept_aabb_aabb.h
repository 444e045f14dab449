// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct swept_aabb_aabb {
  TOUCHSTONE_SIGNATURE(swept_aabb_aabb)
  using InPlane = std::tuple<Aabb2d, Aabb2d, Vector2d>;
  using InSpace = std::tuple<Aabb3d, Aabb3d, Vector3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = FirstContact<double>;
};

}  // namespace touchstone::catalogue::signatures
