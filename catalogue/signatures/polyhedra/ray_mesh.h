// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/ray_mesh.h"

namespace touchstone::catalogue::signatures {

struct ray_mesh : Signature<RayMesh<double>(Ray3d, Meshd)> {
  TOUCHSTONE_SIGNATURE(ray_mesh)
};

}  // namespace touchstone::catalogue::signatures
