// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct sphere_aabb {
  TOUCHSTONE_SIGNATURE(sphere_aabb)
  using InPlane = std::tuple<Circle2d, Aabb2d>;
  using InSpace = std::tuple<Sphere3d, Aabb3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
