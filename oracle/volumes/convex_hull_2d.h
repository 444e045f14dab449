// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: on integers, from vertex to vertex, so that no point lies to the right of the path; the first is the
/// lexicographically least, and of equal points the first in the list. Margin: the least size of twice the area of an
/// edge of the hull and a point that is no end of it, which is 0 if points are equal, inside an edge or all on one
/// line; of two points their squared distance; none of a single one. Time: points times corners. 4,000 points that are
/// all corners take a fraction of a second where their numbers are integers of at most 61 bits in one unit, and some
/// seconds where they are longer.
Truth<ConvexHull2> convex_hull_2d(const std::vector<Point2d>& points);
template <Exact Number>
Truth<ConvexHull2> convex_hull_2d(const std::vector<Point2<Number>>& points);

/// The defect of a hull of these points; "" if it is right, ours or not.
std::string convex_hull_2d_defect(const std::vector<Point2d>& points, const ConvexHull2& hull);

}  // namespace touchstone::oracle
