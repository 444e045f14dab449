// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct aabb_obb {
  TOUCHSTONE_SIGNATURE(aabb_obb)
  using Question = std::tuple<Aabb3d, Obb3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
