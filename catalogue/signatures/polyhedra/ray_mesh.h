// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/ray_mesh.h"

namespace touchstone::catalogue::signatures {

struct ray_mesh {
  TOUCHSTONE_SIGNATURE(ray_mesh)
  using Question = std::tuple<Ray3d, Meshd>;
  using Answer = RayMesh<double>;
};

}  // namespace touchstone::catalogue::signatures
