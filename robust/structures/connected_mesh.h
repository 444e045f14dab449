// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/complexity.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"

namespace touchstone::robust::structures {

/// What the indices of a valid mesh tell: vertices, edges, components, and how faces meet at them. The words' meaning
/// stands in reference/polyhedra/polyhedron_complexity.h. The time is that of sorting the edges.
struct ConnectedMesh {
  explicit ConnectedMesh(const Meshd& mesh);

  PolyhedronComplexity<double> found{};  ///< the answer, as far as indices tell it
  std::vector<Index> component;          ///< of each triangle; numbered in the order of their first ones
};

}  // namespace touchstone::robust::structures
