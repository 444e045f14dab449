// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "audit/uses.h"
#include "geometry/polyhedra.h"

namespace touchstone::audit::meshes {

using Corners = std::vector<Index>;

/// An edge, the lesser vertex first, and the first face that has it.
struct EdgeOfFile {
  Index low, high;
  std::size_t face;
};

/// The connections of faces by the vertices that they use. The terms are those of
/// reference/polyhedra/polyhedron_complexity.h, but all occurrences are listed, not only the first. A face may use a
/// corner twice. The time is that of sorting the edges.
struct Surface {
  Surface(const std::vector<Corners>& faces, std::size_t vertices);

  std::size_t vertices = 0, edges = 0, components = 0;
  std::vector<EdgeOfFile> open, turned, crowded;  ///< in ascending order
  std::vector<Index> pinched;                     ///< at edges of at most two faces
  std::vector<std::size_t> component;             ///< of each face; numbered in the order of first faces

  /// Faces are in one sheet if a chain of edges of two faces each connects them. Numbered like components.
  std::vector<std::size_t> sheet;
  std::vector<bool>
      one_sided;  ///< for each sheet: no choice of orientations agrees at all of its edges, as in a Moebius strip
  std::vector<bool> closed;   ///< for each sheet: it contains each of its edges an even number of times
  std::vector<bool> against;  ///< for each face: its orientation is opposite to that of the first of its sheet
};

}  // namespace touchstone::audit::meshes
