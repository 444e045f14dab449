// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/capsules.h"

namespace touchstone::catalogue::signatures {

struct sphere_capsule {
  TOUCHSTONE_SIGNATURE(sphere_capsule)
  using Question = std::tuple<Sphere3d, Capsule3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
