// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct rigid_body_collision {
  TOUCHSTONE_SIGNATURE(rigid_body_collision)
  using Question = std::tuple<RigidBodyd, RigidBodyd, Point3d, Vector3d, double>;
  using Answer = Motions<double>;
};

}  // namespace touchstone::catalogue::signatures
