// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: on integers, from face to face over their edges, every face with all points in its plane and gone round once;
/// one answer of many: faces cut from their least place, triangles from their least place on and sorted, and of equal
/// points the first in the list. Margin, a length to the third power: the least size of the determinant of a face's
/// triangle and any other point, which is 0 if four points lie in the plane of a face, or points are equal. For three
/// points: the greatest coordinate of the cross product of their differences from the first, times the greatest of
/// these differences; of two points the third power of that; of four or more in one plane 0; none of a single one.
template <Exact Number = double>
Truth<ConvexHull> convex_hull(const std::vector<Point3<Number>>& points);

/// The defect of a hull of these points; "" if it is right, ours or not.
std::string convex_hull_defect(const std::vector<Point3d>& points, const ConvexHull& hull);

}  // namespace touchstone::oracle
