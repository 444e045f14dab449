// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct sphere_obb {
  TOUCHSTONE_SIGNATURE(sphere_obb)
  using Question = std::tuple<Sphere3d, Obb3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
