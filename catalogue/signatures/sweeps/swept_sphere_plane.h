// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct swept_sphere_plane : Signature<FirstContact<double>(Sphere3d, Vector3d, Plane3d)> {
  TOUCHSTONE_SIGNATURE(swept_sphere_plane)
};

}  // namespace touchstone::catalogue::signatures
