// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/complexity.h"

namespace touchstone::catalogue::signatures {

struct polyhedron_complexity : Signature<PolyhedronComplexity<double>(Meshd)> {
  TOUCHSTONE_SIGNATURE(polyhedron_complexity)
};

}  // namespace touchstone::catalogue::signatures
