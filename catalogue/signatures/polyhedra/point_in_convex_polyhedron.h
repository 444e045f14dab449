// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct point_in_convex_polyhedron {
  TOUCHSTONE_SIGNATURE(point_in_convex_polyhedron)
  using Question = std::tuple<Meshd, Point3d>;
  using Answer = Location;
};

}  // namespace touchstone::catalogue::signatures
