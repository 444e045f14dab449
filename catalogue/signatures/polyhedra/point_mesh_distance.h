// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/point_mesh_distance.h"

namespace touchstone::catalogue::signatures {

struct point_mesh_distance : Signature<PointMeshDistance<double>(Point3d, Meshd)> {
  TOUCHSTONE_SIGNATURE(point_mesh_distance)
};

}  // namespace touchstone::catalogue::signatures
