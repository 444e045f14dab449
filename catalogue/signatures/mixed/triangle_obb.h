// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct triangle_obb {
  TOUCHSTONE_SIGNATURE(triangle_obb)
  using Question = std::tuple<Triangle3d, Obb3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
