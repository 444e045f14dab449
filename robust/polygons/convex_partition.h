// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/invalid_input.h"
#include "geometry/polygons.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Cuts a simple polygon into convex pieces: lists of indices of its vertices, counter-clockwise.
///
/// The polygon may run in either direction. At most 2 r + 1 pieces, r the number of reflex vertices: at most four times
/// the least number. Flat vertices stay in the pieces. Right for all finite doubles, and the same pieces in the same
/// order in every floating-point environment; in time n log n. NaN and infinities throw InvalidInput, which names the
/// field and "finite number"; so do fewer than 3 vertices and a polygon that is not simple (with the vertex). Contract:
/// reference/polygons/convex_partition.h.
std::vector<std::vector<Index>> convex_partition(const Polygon2d& polygon);

namespace stages {

/// The latest stage that one of its decisions needed.
struct convex_partition : Signatures<decltype(robust::convex_partition)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
