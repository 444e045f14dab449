// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct obb_obb : Signature<Contact(Obb3d, Obb3d)> {
  TOUCHSTONE_SIGNATURE(obb_obb)
};

}  // namespace touchstone::catalogue::signatures
