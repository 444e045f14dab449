// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct swept_convex_polyhedra : Signature<FirstContact<double>(Meshd, Meshd, Vector3d)> {
  TOUCHSTONE_SIGNATURE(swept_convex_polyhedra)
};

}  // namespace touchstone::catalogue::signatures
