// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: for each normal the places of all points sorted by N . P in rationals; the slab has the exact value of the
/// first and of the last. Nothing is decided: no margin.
///
/// Certificate: "extreme_points": for each normal the place of a point with the `least` N . P, and of one with the
/// `greatest`.
template <Exact Number = double>
Truth<std::vector<Slab<Rational>>> kdop_of_points(const std::vector<Point3<Number>>& points,
                                                  const std::vector<Vector3<Number>>& normals);

/// The defect of slabs in doubles: the point that is farthest outside of the first slab that loses one, and its
/// distance; otherwise the end that is too far out, or not a number. "" if they are right, ours or not.
std::string kdop_of_points_defect(const std::vector<Point3d>& points, const std::vector<Vector3d>& normals,
                                  const std::vector<Slabd>& slabs);

}  // namespace touchstone::oracle
