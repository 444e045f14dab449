// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/shape/described_solids.h"
#include "catalogue/signatures/signature.h"

namespace touchstone::catalogue::signatures {

struct polyhedron_polyhedron {
  TOUCHSTONE_SIGNATURE(polyhedron_polyhedron)
  using Question = std::tuple<Meshd, Meshd>;
  using Answer = PolyhedronPolyhedron;
};

}  // namespace touchstone::catalogue::signatures
