// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the exact ball of the method, on integers; the radius is a square root. box: the middle between the first and
/// the last of the sorted coordinates; centroid: the mean. smallest: of all sets of up to four points, their ball with
/// a center that is a convex combination of them, all at the same distance, and no point farther: the conditions of the
/// least. Sets are taken from the last ball's and the point farthest from it, until no point is outside. ritter: as the
/// contract defines it, with roots and quotients rounded up more than 300 binary digits below the last of the points,
/// so that the ball contains them all; its numbers are not those of the definition, but so near that they round alike.
///
/// Nothing is decided: there is no margin.
///
/// Certificate: box, centroid: "farthest_point" (`point`, its place). smallest: "support" (places of `points` and their
/// `weights`). ritter: "lower_bound" (the same of the smallest ball, of which it proves the radius).
template <Exact Number = double>
Truth<Sphere3<Surd>> bounding_sphere(const std::vector<Point3<Number>>& points, SphereMethod method);

/// The defect of a ball that is claimed to be the method's, in the words of the contract
/// (reference/volumes/bounding_sphere.h); "" if it is right, ours or not.
std::string bounding_sphere_defect(const std::vector<Point3d>& points, SphereMethod method, const Sphere3d& ball);

}  // namespace touchstone::oracle
