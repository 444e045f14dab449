// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: one of the right boxes, without rounding: along three rational axes at right angles, each face through a
/// point. Where the points are on one plane or line, that is where an axis points, and the half axes across it are 0.
/// Otherwise axes are near those of the covariance: the covariance, in integers, is squared again and again until it
/// has one direction, which is replaced by simple ratios; the next is what the same finds across it.
///
/// Nothing is decided: there is no margin.
///
/// Certificate: "touched_faces": for each half axis that is not 0 the place of the point `least` far along it, and of
/// the one `most` far.
template <Exact Number = double>
Truth<Obb3<Rational>> obb_of_points(const std::vector<Point3<Number>>& points);

/// The defect of a box, in the words of the contract (reference/volumes/obb_of_points.h): first of all the point that
/// is farthest outside, and its distance. "" if it is right, ours or not.
std::string obb_of_points_defect(const std::vector<Point3d>& points, const Obb3d& box);
std::string obb_of_points_defect(const std::vector<Point3d>& points, const Obb3<Rational>& box);

}  // namespace touchstone::oracle
