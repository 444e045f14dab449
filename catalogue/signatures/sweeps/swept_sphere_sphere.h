// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct swept_sphere_sphere : Signature<FirstContact<double>(Sphere3d, Sphere3d, Vector3d, Vector3d)> {
  TOUCHSTONE_SIGNATURE(swept_sphere_sphere)
};

}  // namespace touchstone::catalogue::signatures
