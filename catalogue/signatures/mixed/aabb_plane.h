// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct aabb_plane {
  TOUCHSTONE_SIGNATURE(aabb_plane)
  using Question = std::tuple<Aabb3d, Plane3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
