// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue::signatures {

struct sphere_triangle {
  TOUCHSTONE_SIGNATURE(sphere_triangle)
  using Question = std::tuple<Sphere3d, Triangle3d>;
  using Answer = Contact;
};

}  // namespace touchstone::catalogue::signatures
