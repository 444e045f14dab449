// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct sphere_obb : Signature<Contact(Sphere3d, Obb3d)> {
  TOUCHSTONE_SIGNATURE(sphere_obb)
};

}  // namespace touchstone::catalogue::signatures
