// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The convex hull of points in space, by their indices in the list: the point (dimension 0), the ends of the segment
/// (1), the extreme points of the polygon (2), or the faces of the solid (3), triangles counter-clockwise as seen from
/// outside.
///
/// Strict: no vertex lies on a segment between two other points; a flat face of more than three corners is fanned from
/// the corner of least index. Triangles begin with their least index and are sorted by their indices, and of equal
/// points the first in the list is named, so that the answer depends on the points alone. Right for all finite doubles,
/// and the same in every floating-point environment. The time was about n log n in all measurements (bench/README.md);
/// no bound below n^2 is proved. Requires fewer than 2^30 points (throws std::length_error otherwise). NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so does an empty list. `threads` is the
/// number of threads that may be used, 0 for as many as the machine runs at once: the answer is the same. Contract:
/// reference/volumes/convex_hull.h.
ConvexHull convex_hull(const std::vector<Point3d>& points);
ConvexHull convex_hull(const std::vector<Point3d>& points, std::size_t threads);

namespace stages {

/// The latest stage that one of its decisions needed.
struct convex_hull {
  static Decided<ConvexHull> ask(const std::vector<Point3d>& points, std::size_t threads = 1);
};

}  // namespace stages

}  // namespace touchstone::robust
