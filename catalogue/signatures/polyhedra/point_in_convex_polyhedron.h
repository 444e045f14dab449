// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_in_convex_polyhedron : Signature<Location(Meshd, Point3d)> {
  TOUCHSTONE_SIGNATURE(point_in_convex_polyhedron)
};

}  // namespace touchstone::catalogue::signatures
