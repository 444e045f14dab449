// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct sphere_plane : Signature<Contact(Sphere3d, Plane3d)> {
  TOUCHSTONE_SIGNATURE(sphere_plane)
};

}  // namespace touchstone::catalogue::signatures
