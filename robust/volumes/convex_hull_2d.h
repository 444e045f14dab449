// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The convex hull of points in the plane, by their indices in the list: the point (dimension 0), the ends of the
/// segment (1), or the extreme points of the polygon, counter-clockwise (2).
///
/// Strict: no vertex lies on a segment between two other points. The first vertex, or end, is the lexicographically
/// least (x, then y), and of equal points the first in the list is named. Right for all finite doubles, and the same
/// answer in every floating-point environment. Time n log n at most; points inside the polygon of the extremes in
/// eight directions are not sorted. NaN and infinities throw InvalidInput, which names the field and "finite number";
/// so does an empty list. Contract: reference/volumes/convex_hull_2d.h.
ConvexHull2 convex_hull_2d(const std::vector<Point2d>& points);

namespace stages {

/// The latest stage that one of its decisions needed.
struct convex_hull_2d : Signatures<decltype(robust::convex_hull_2d)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
