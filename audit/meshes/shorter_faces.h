// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "audit/meshes/surface.h"

namespace touchstone::audit::meshes {

/// Faces in which no vertex follows itself.
struct ShorterFaces {
  std::vector<Corners> faces;             ///< of at least three corners
  std::vector<std::size_t> face_in_file;  ///< of each, the place of the face that it was
  std::vector<std::size_t> shortened,
      dropped;  ///< places of those that lost corners, and that have fewer than three left
};

/// Each vertex v is replaced by into[v], and of a corner that is named several times in a row one is left.
ShorterFaces shorter_faces(const std::vector<Corners>& faces, const std::vector<Index>& into);

/// Whether a corner is named twice in a row.
bool repeats_corner(const Corners& corners);

}  // namespace touchstone::audit::meshes
