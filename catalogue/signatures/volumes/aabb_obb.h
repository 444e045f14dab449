// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct aabb_obb : Signature<Contact(Aabb3d, Obb3d)> {
  TOUCHSTONE_SIGNATURE(aabb_obb)
};

}  // namespace touchstone::catalogue::signatures
