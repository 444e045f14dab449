// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue::signatures {

struct triangle_aabb : Signature<Contact(Triangle3d, Aabb3d)> {
  TOUCHSTONE_SIGNATURE(triangle_aabb)
};

}  // namespace touchstone::catalogue::signatures
