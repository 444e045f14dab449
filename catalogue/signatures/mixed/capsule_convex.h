// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct capsule_convex : Signature<Contact(Capsule3d, Meshd)> {
  TOUCHSTONE_SIGNATURE(capsule_convex)
};

}  // namespace touchstone::catalogue::signatures
