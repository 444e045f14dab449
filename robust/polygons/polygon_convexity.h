// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Classifies a ring of vertices as `convex`, `concave`, `not_simple` (edges other than neighbours meet) or
/// `degenerate` (equal neighbours, or all collinear); its orientation, ccw or cw; and whether it is strictly convex,
/// without three collinear neighbours.
///
/// Right for all finite doubles in every floating-point environment. If no two turns differ in sign, the winding number
/// of the directions distinguishes convex from crossing, in linear time; only a ring that turns to both sides is
/// searched for edges that meet. NaN and infinities throw InvalidInput, which names the field and "finite number"; so
/// do fewer than 3 vertices. Contract: reference/polygons/polygon_convexity.h.
PolygonConvexity polygon_convexity(const Polygon2d& polygon);

namespace stages {

/// The latest stage that one of its decisions needed.
struct polygon_convexity : Signatures<decltype(robust::polygon_convexity)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
