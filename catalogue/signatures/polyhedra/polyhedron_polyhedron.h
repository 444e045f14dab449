// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/solids.h"

namespace touchstone::catalogue::signatures {

struct polyhedron_polyhedron {
  TOUCHSTONE_SIGNATURE(polyhedron_polyhedron)
  using Question = std::tuple<Meshd, Meshd>;
  using Answer = PolyhedronPolyhedron;
};

}  // namespace touchstone::catalogue::signatures
