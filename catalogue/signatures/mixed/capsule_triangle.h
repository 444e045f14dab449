// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct capsule_triangle {
  TOUCHSTONE_SIGNATURE(capsule_triangle)
  using Question = std::tuple<Capsule3d, Triangle3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
