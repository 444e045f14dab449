// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct kdop_kdop : Signature<Contact(Kdop3d, Kdop3d)> {
  TOUCHSTONE_SIGNATURE(kdop_kdop)
};

}  // namespace touchstone::catalogue::signatures
