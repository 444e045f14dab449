// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Whether a ring of vertices is `convex`, `concave`, `not_simple` (edges meet elsewhere than neighbours do) or
/// `degenerate` (equal neighbours, or all on one line); which way round it runs, ccw or cw; and whether it is strictly
/// convex, without three neighbours on a line.
///
/// Right for all finite doubles in every floating-point environment. If no two turns differ in sign, the number of
/// times that the ring goes round tells convex from crossing, in linear time; only a ring that turns both ways is
/// searched for edges that meet. NaN and infinities throw InvalidInput, which names the field and "finite number"; so
/// do fewer than 3 vertices. Contract: reference/polygons/polygon_convexity.h.
PolygonConvexity polygon_convexity(const Polygon2d& polygon);

/// Each stage alone, for tests and other operations; no promise to users.
namespace stages {

/// The latest stage that one of its decisions needed.
struct polygon_convexity : Signatures<decltype(robust::polygon_convexity)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
