// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/capsules.h"

namespace touchstone::catalogue::signatures {

struct capsule_capsule : Signature<Contact(Capsule3d, Capsule3d)> {
  TOUCHSTONE_SIGNATURE(capsule_capsule)
};

}  // namespace touchstone::catalogue::signatures
