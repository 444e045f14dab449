// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "audit/meshes/formats/mesh_file.h"
#include "report/uses.h"

namespace touchstone::report {

/// A mesh as drawn.
struct CoarseMesh {
  std::vector<Point3d> vertices;
  std::vector<std::vector<Index>> faces;
  std::size_t cells = 0;  ///< number of cells along an axis, whose vertices are merged; 0: unchanged
};

/// The faces of a mesh, if they have at most that many corners together. Otherwise its box is divided into cells, as
/// many along each axis, and the vertices in a cell become one of them: faces with fewer than three corners left are
/// removed, and so are those that repeat an earlier one. Uses the greatest number of cells, a power of two, that leaves
/// few enough. Faces keep their orientations. The last vertices are such that the box of all vertices is that of the
/// mesh.
CoarseMesh coarse_mesh(const MeshFile& mesh, std::size_t most_corners);

}  // namespace touchstone::report
