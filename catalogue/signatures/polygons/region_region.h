// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct region_region : Signature<Contact(Region2d, Region2d)> {
  TOUCHSTONE_SIGNATURE(region_region)
};

}  // namespace touchstone::catalogue::signatures
