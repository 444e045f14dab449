// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/bodies.h"

namespace touchstone::catalogue::signatures {

struct rigid_body_collision : Signature<Motions<double>(RigidBodyd, RigidBodyd, Point3d, Vector3d, double)> {
  TOUCHSTONE_SIGNATURE(rigid_body_collision)
};

}  // namespace touchstone::catalogue::signatures
