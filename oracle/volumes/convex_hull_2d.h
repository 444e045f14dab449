// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: on integers, the farthest point from a line through two extreme ones, again and again, until no point lies to
/// the right of the path; the first is the lexicographically least, and of equal points the first in the list. Margin:
/// the least size of twice the area of an edge of the hull and a point that is no end of it, which is 0 if points are
/// equal, inside an edge or all on one line; of two points their squared distance; none of a single one. Time: points
/// that are no corners times corners for the margin; the rest about n log n, at most points times corners.
template <Exact Number = double>
Truth<ConvexHull2> convex_hull_2d(const std::vector<Point2<Number>>& points);

/// The defect of a hull of these points; "" if it is right, ours or not.
std::string convex_hull_2d_defect(const std::vector<Point2d>& points, const ConvexHull2& hull);

}  // namespace touchstone::oracle
