// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/polygons.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Cuts a simple polygon of n vertices into n - 2 triangles of positive area: triples of indices of its vertices,
/// counter-clockwise.
///
/// The polygon may run in either direction and have flat vertices. Right for all finite doubles, and the same triangles
/// in the same order in every floating-point environment. One sweep over the plane tests whether the polygon is simple
/// and triangulates it, in time n log n. NaN and infinities throw InvalidInput, which names the field and "finite
/// number"; so do fewer than 3 vertices and a polygon that is not simple (with the vertex). Contract:
/// reference/polygons/triangulate_polygon.h.
std::vector<std::vector<Index>> triangulate_polygon(const Polygon2d& polygon);

namespace stages {

/// The latest stage that one of its decisions needed.
struct triangulate_polygon : Signatures<decltype(robust::triangulate_polygon)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
