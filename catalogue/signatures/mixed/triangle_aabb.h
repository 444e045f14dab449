// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue::signatures {

struct triangle_aabb {
  TOUCHSTONE_SIGNATURE(triangle_aabb)
  using Question = std::tuple<Triangle3d, Aabb3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
