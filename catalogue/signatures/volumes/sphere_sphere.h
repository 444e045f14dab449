// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct sphere_sphere {
  TOUCHSTONE_SIGNATURE(sphere_sphere)
  using InPlane = std::tuple<Circle2d, Circle2d>;
  using InSpace = std::tuple<Sphere3d, Sphere3d>;
  using Question = std::variant<InPlane, InSpace>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
