// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "geometry/polyhedra.h"

/// Triangulations of faces that are not planar, which no triangulation represents exactly.
namespace touchstone::audit {

/// The three functions triangulate a face with more than three corners, all of them vertices. Its projection is the one
/// along the coordinate axis nearest to its normal (Newell's, in double arithmetic). The triangles have the orientation
/// of the face.

/// Like the exact triangulation of the projection; nullopt if that encloses no area or crosses itself.
std::optional<std::vector<Face>> cut_as_projected(const std::vector<Point3d>& vertices,
                                                  const std::vector<Index>& corners);

/// By ear clipping of the projection, each time the ear with the shortest diagonal, the first of equal ones: a
/// quadrilateral is cut along its shorter diagonal, unless only the other one lies inside. Lengths are those in space.
/// nullopt if there is no ear.
std::optional<std::vector<Face>> cut_along_shortest(const std::vector<Point3d>& vertices,
                                                    const std::vector<Index>& corners);

/// All diagonals start at the first corner, whatever lies between.
std::vector<Face> cut_as_fan(const std::vector<Index>& corners);

}  // namespace touchstone::audit
