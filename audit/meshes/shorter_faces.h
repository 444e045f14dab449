// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "audit/meshes/surface.h"

namespace touchstone::audit::meshes {

/// Faces without consecutive repetitions of a vertex.
struct ShorterFaces {
  std::vector<Corners> faces;             ///< of at least three corners
  std::vector<std::size_t> face_in_file;  ///< for each, the index of the original face
  std::vector<std::size_t> shortened,
      dropped;  ///< indices of those that lost corners, and of those that have fewer than three left
};

/// Each vertex v is replaced by into[v], and a corner that is repeated consecutively is reduced to one.
ShorterFaces shorter_faces(const std::vector<Corners>& faces, const std::vector<Index>& into);

/// True if a corner is repeated consecutively.
bool repeats_corner(const Corners& corners);

}  // namespace touchstone::audit::meshes
