// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The convex hull of points in space, by their places in the list: the point (dimension 0), the ends of the segment
/// (1), the extreme points of the polygon (2), or the faces of the solid (3), triangles counter-clockwise as seen from
/// outside.
///
/// Strict: no vertex lies on a segment between two other points; a flat face of more than three corners is cut from
/// the corner of the least place. Triangles begin with their least place and are sorted by their places, and of equal
/// points the first in the list is named, so that the answer depends on the points alone. Right for all finite
/// doubles, and the same in every floating-point environment. Time about n log n on all that was measured
/// (bench/README.md); no bound below n^2 is proved. Fewer than 2^30 points (else std::length_error). NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so does an empty list. Contract:
/// reference/volumes/convex_hull.h.
ConvexHull convex_hull(const std::vector<Point3d>& points);

/// Each stage alone, for tests and other operations; no promise to users.
namespace stages {

/// The latest stage that one of its decisions needed.
struct convex_hull : Signatures<decltype(robust::convex_hull)> {
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
