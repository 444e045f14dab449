// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "audit/meshes/formats/mesh_file.h"
#include "report/uses.h"

namespace touchstone::report {

/// A mesh as it is drawn.
struct CoarseMesh {
  std::vector<Point3d> vertices;
  std::vector<std::vector<Index>> faces;
  std::size_t cells = 0;  ///< vertices in one of so many cells along an axis are one; 0: the mesh is drawn as it is
};

/// The faces of a mesh, as long as they have at most that many corners together. Otherwise its box is cut into cells,
/// as many along each axis, and the vertices in a cell become one of them: faces with fewer than three corners left go,
/// and so do those that repeat an earlier one. The most cells are taken that leave few enough, a power of two. Faces
/// keep their directions. The last vertices are such that the box of all vertices is that of the mesh.
CoarseMesh coarse_mesh(const MeshFile& mesh, std::size_t most_corners);

}  // namespace touchstone::report
