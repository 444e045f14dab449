// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct capsule_triangle : Signature<Contact(Capsule3d, Triangle3d)> {
  TOUCHSTONE_SIGNATURE(capsule_triangle)
};

}  // namespace touchstone::catalogue::signatures
