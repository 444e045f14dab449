// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "geometry/polyhedra.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Refuses a mesh whose polygons are not planar or whose triangles are no valid cut of them, by the definition in
/// geometry/polyhedra.h: triangles and polygon have one boundary, every two triangles are clipped against each other
/// and leave no area, and no corner has weights in a triangle of which it is none. Its numbers are finite and its
/// indices those of vertices.
void validate_polygons(const std::string& field, const Mesh<Rational>& mesh);
void validate_polygons(const std::string& field, const Meshd& mesh);

}  // namespace touchstone::oracle
