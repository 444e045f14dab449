// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct ray_obb : Signature<Passage<double>(Ray3d, Obb3d)> {
  TOUCHSTONE_SIGNATURE(ray_obb)
};

}  // namespace touchstone::catalogue::signatures
