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

/// How faces are connected by the vertices that they name. The words mean what they mean in
/// reference/polyhedra/polyhedron_complexity.h, but all places are listed and not the first alone. A face may name a
/// corner twice. The time is that of sorting the edges.
struct Surface {
  Surface(const std::vector<Corners>& faces, std::size_t vertices);

  std::size_t vertices = 0, edges = 0, components = 0;
  std::vector<EdgeOfFile> open, turned, crowded;  ///< in ascending order
  std::vector<Index> pinched;                     ///< at edges of two faces at most
  std::vector<std::size_t> component;             ///< of each face; numbered in the order of their first faces

  /// Faces are of one sheet if a chain of edges of two faces each joins them. Numbered as components are.
  std::vector<std::size_t> sheet;
  std::vector<bool>
      one_sided;  ///< of each sheet: no choice of directions agrees at all of its edges, as in a Moebius strip
  std::vector<bool> closed;   ///< of each sheet: it has each of its edges an even number of times
  std::vector<bool> against;  ///< of each face: it runs the other way than the first of its sheet
};

}  // namespace touchstone::audit::meshes
