// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct obb_obb {
  TOUCHSTONE_SIGNATURE(obb_obb)
  using Question = std::tuple<Obb3d, Obb3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
