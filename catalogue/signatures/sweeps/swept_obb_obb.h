// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/volumes.h"

namespace touchstone::catalogue::signatures {

struct swept_obb_obb : Signature<FirstContact<double>(Obb3d, Obb3d, Vector3d)> {
  TOUCHSTONE_SIGNATURE(swept_obb_obb)
};

}  // namespace touchstone::catalogue::signatures
