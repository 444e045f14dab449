// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct obb_plane : Signature<Contact(Obb3d, Plane3d)> {
  TOUCHSTONE_SIGNATURE(obb_plane)
};

}  // namespace touchstone::catalogue::signatures
