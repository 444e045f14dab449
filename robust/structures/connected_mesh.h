// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/complexity.h"
#include "geometry/polyhedra.h"
#include "robust/kernel/filters/strict_math.h"
#include "robust/structures/edge_sides.h"

namespace touchstone::robust::structures {

/// The properties of a valid mesh that follow from its indices: vertices, edges, components, and how faces meet at
/// them. reference/polyhedra/polyhedron_complexity.h defines the terms. The time is that of grouping the edges.
struct ConnectedMesh {
  explicit ConnectedMesh(const Meshd& mesh);

  PolyhedronComplexity<double> found{};  ///< the answer, as far as it follows from indices
  std::vector<Index> component;          ///< of each triangle; numbered by their first triangles
  EdgeSides sides;                       ///< of the faces as they are named

 private:
  ConnectedMesh(const Meshd& mesh, const FaceCorners& corners);
};

}  // namespace touchstone::robust::structures
