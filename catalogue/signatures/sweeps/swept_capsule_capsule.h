// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/capsules.h"

namespace touchstone::catalogue::signatures {

struct swept_capsule_capsule : Signature<FirstContact<double>(Capsule3d, Capsule3d, Vector3d)> {
  TOUCHSTONE_SIGNATURE(swept_capsule_capsule)
};

}  // namespace touchstone::catalogue::signatures
