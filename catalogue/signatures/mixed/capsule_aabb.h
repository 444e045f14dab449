// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct capsule_aabb {
  TOUCHSTONE_SIGNATURE(capsule_aabb)
  using Question = std::tuple<Capsule3d, Aabb3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
