// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/capsules.h"

namespace touchstone::catalogue::signatures {

struct sphere_capsule : Signature<Contact(Sphere3d, Capsule3d)> {
  TOUCHSTONE_SIGNATURE(sphere_capsule)
};

}  // namespace touchstone::catalogue::signatures
