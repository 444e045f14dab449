// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct sphere_plane {
  TOUCHSTONE_SIGNATURE(sphere_plane)
  using Question = std::tuple<Sphere3d, Plane3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
