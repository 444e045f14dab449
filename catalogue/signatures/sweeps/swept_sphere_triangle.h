// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/triangles.h"

namespace touchstone::catalogue::signatures {

struct swept_sphere_triangle : Signature<FirstContact<double>(Sphere3d, Vector3d, Triangle3d)> {
  TOUCHSTONE_SIGNATURE(swept_sphere_triangle)
};

}  // namespace touchstone::catalogue::signatures
