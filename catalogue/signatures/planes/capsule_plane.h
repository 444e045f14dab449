// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/capsules.h"

namespace touchstone::catalogue::signatures {

struct capsule_plane {
  TOUCHSTONE_SIGNATURE(capsule_plane)
  using Question = std::tuple<Capsule3d, Plane3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
