// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/families/meshes/lattice_hull.h"

namespace touchstone::catalogue {

/// The surface of a union of cubes, cell (x, y, z) being [12 x, 12 (x + 1)] and so on: the squares between a cell of
/// the list and one that is not in it, cut into two triangles each, counter-clockwise from outside. A vertex for every
/// lattice point that a square has. Where cubes share only an edge, four triangles have it.
Meshd cube_surface(const std::vector<LatticePoint>& cells);

}  // namespace touchstone::catalogue
