// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct kdop_of_points {
  TOUCHSTONE_SIGNATURE(kdop_of_points)
  using Points = std::vector<Point3d>;
  using Normals = std::vector<Vector3d>;
  using Question = std::tuple<Points, Normals>;
  using Answer = std::vector<Slab<double>>;
};

}  // namespace touchstone::catalogue::signatures
