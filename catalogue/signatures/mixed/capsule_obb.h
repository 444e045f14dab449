// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct capsule_obb : Signature<Contact(Capsule3d, Obb3d)> {
  TOUCHSTONE_SIGNATURE(capsule_obb)
};

}  // namespace touchstone::catalogue::signatures
