// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/complexity.h"

namespace touchstone::catalogue::signatures {

struct polyhedron_complexity {
  TOUCHSTONE_SIGNATURE(polyhedron_complexity)
  using Question = std::tuple<Meshd>;
  using Answer = PolyhedronComplexity<double>;
};

}  // namespace touchstone::catalogue::signatures
