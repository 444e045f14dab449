// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/capsules.h"

namespace touchstone::catalogue::signatures {

struct capsule_plane : Signature<Contact(Capsule3d, Plane3d)> {
  TOUCHSTONE_SIGNATURE(capsule_plane)
};

}  // namespace touchstone::catalogue::signatures
