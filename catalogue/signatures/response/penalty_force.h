// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct penalty_force : Signature<Vector3<double>(Point3d, Vector3d, Plane3d, double, double)> {
  TOUCHSTONE_SIGNATURE(penalty_force)
};

}  // namespace touchstone::catalogue::signatures
