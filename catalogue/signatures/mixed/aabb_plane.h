// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct aabb_plane : Signature<Contact(Aabb3d, Plane3d)> {
  TOUCHSTONE_SIGNATURE(aabb_plane)
};

}  // namespace touchstone::catalogue::signatures
