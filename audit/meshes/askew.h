// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/polyhedra.h"

/// Cuts of faces that are not planar, which no cut represents exactly.
namespace touchstone::audit {

/// What the three functions cut is a face with more than three corners, all of them vertices. Its projection is the one
/// along the axis of coordinates that is nearest to its normal (Newell's, in double arithmetic). The triangles turn as
/// the face does.

/// As the exact cut of the projection is; empty where that encloses no area or crosses itself.
std::optional<std::vector<Face>> cut_as_projected(const std::vector<Point3d>& vertices,
                                                  const std::vector<Index>& corners);

/// By clipping ears of the projection, each time the one with the shortest diagonal, of equal ones the first: a
/// quadrilateral along its shorter diagonal, unless only the other one lies inside. Lengths are those in space. Empty
/// where no ear is left.
std::optional<std::vector<Face>> cut_along_shortest(const std::vector<Point3d>& vertices,
                                                    const std::vector<Index>& corners);

/// All diagonals leave the first corner, whatever lies between.
std::vector<Face> cut_as_fan(const std::vector<Index>& corners);

}  // namespace touchstone::audit
