// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/complexity.h"
#include "geometry/invalid_input.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/strict_math.h"

namespace touchstone::robust {

/// How many vertices, edges, faces and components a mesh has, and whether it is closed, oriented and a manifold, at its
/// edges and at its vertices. Nothing is measured, so nothing is rounded; the time is that of sorting its edges. NaN
/// and infinities throw InvalidInput, and so does a face that is no triangle of the mesh. Contract:
/// reference/polyhedra/polyhedron_complexity.h.
PolyhedronComplexity<double> polyhedron_complexity(const Meshd& mesh);

}  // namespace touchstone::robust
