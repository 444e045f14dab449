// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <tuple>
#include <vector>

#include "geometry/answers.h"
#include "geometry/points.h"
#include "geometry/volumes.h"

/// The distance of an answer that a checker refuses from one that it accepts: the amount by which its decisions are on
/// the wrong side, relative to the greatest numbers of the question to the power of the degree. Empty if it is
/// malformed for any numbers: a duplicate edge, fields of another dimension, a list of another length, NaN.
///
/// Computed in long double, whose last place is 2^-11 of a double's: the excess is compared with hundreds of those.
namespace touchstone::catalogue {

using Excess = std::optional<double>;

Excess excess_of_hull(const std::vector<Point3d>& points, const ConvexHull& hull);
Excess excess_of_hull(const std::vector<Point2d>& points, const ConvexHull2& hull);
/// Convex counter-clockwise pieces of a polygon; those of the truth may be others.
Excess excess_of_pieces(const std::tuple<Polygon2d>& question, const std::vector<std::vector<Index>>& pieces,
                        const std::vector<std::vector<Index>>& truth);
/// For a point outside, or a radius beyond that of the right ball.
Excess excess_of_ball(const std::vector<Point3d>& points, const Sphere3d& ball, const Sphere3d& right);
Excess excess_of_slabs(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals,
                       const std::vector<Slabd>& slabs);
Excess excess_of_box(const std::vector<Point3d>& points, const Obb3d& box);

}  // namespace touchstone::catalogue
