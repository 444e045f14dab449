// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct sphere_convex : Signature<Contact(Sphere3d, Meshd)> {
  TOUCHSTONE_SIGNATURE(sphere_convex)
};

}  // namespace touchstone::catalogue::signatures
