// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/polygons.h"

namespace touchstone {

/// What a mesh is made of, and whether it is a surface. What the words mean stands in
/// reference/polyhedra/polyhedron_complexity.h.
template <class Real>
struct PolyhedronComplexity {
  Index vertices, edges, faces, components;
  Real euler;  ///< vertices - edges + faces, which may be negative
  bool closed, oriented, edge_manifold, vertex_manifold;
  friend bool operator==(const PolyhedronComplexity&, const PolyhedronComplexity&) = default;
};

}  // namespace touchstone
