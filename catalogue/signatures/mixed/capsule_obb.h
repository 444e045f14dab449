// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct capsule_obb {
  TOUCHSTONE_SIGNATURE(capsule_obb)
  using Question = std::tuple<Capsule3d, Obb3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
