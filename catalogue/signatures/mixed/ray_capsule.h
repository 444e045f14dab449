// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/capsules.h"
#include "geometry/rays.h"

namespace touchstone::catalogue::signatures {

struct ray_capsule : Signature<Passage<double>(Ray3d, Capsule3d)> {
  TOUCHSTONE_SIGNATURE(ray_capsule)
};

}  // namespace touchstone::catalogue::signatures
