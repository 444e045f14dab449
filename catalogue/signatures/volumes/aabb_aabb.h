// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct aabb_aabb {
  TOUCHSTONE_SIGNATURE(aabb_aabb)
  using InPlane = std::tuple<Aabb2d, Aabb2d>;
  using InSpace = std::tuple<Aabb3d, Aabb3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
