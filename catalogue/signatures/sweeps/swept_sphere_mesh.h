// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/ray_mesh.h"

namespace touchstone::catalogue::signatures {

struct swept_sphere_mesh : Signature<FirstFaceContact<double>(Sphere3d, Vector3d, Meshd)> {
  TOUCHSTONE_SIGNATURE(swept_sphere_mesh)
};

}  // namespace touchstone::catalogue::signatures
