// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue::signatures {

struct sphere_triangle : Signature<Contact(Sphere3d, Triangle3d)> {
  TOUCHSTONE_SIGNATURE(sphere_triangle)
};

}  // namespace touchstone::catalogue::signatures
