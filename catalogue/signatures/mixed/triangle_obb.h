// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct triangle_obb : Signature<Contact(Triangle3d, Obb3d)> {
  TOUCHSTONE_SIGNATURE(triangle_obb)
};

}  // namespace touchstone::catalogue::signatures
