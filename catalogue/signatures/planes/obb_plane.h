// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct obb_plane {
  TOUCHSTONE_SIGNATURE(obb_plane)
  using Question = std::tuple<Obb3d, Plane3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
