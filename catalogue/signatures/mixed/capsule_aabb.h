// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct capsule_aabb : Signature<Contact(Capsule3d, Aabb3d)> {
  TOUCHSTONE_SIGNATURE(capsule_aabb)
};

}  // namespace touchstone::catalogue::signatures
