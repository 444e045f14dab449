// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/signatures/signature.h"
#include "geometry/solids.h"

namespace touchstone::catalogue::signatures {

struct polyhedron_polyhedron : Signature<PolyhedronPolyhedron(Meshd, Meshd)> {
  TOUCHSTONE_SIGNATURE(polyhedron_polyhedron)
};

}  // namespace touchstone::catalogue::signatures
