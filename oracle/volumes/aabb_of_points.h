// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the places of the points are sorted by each coordinate, on rationals; the box has that of the first and that
/// of the last. Nothing is decided, and nothing is rounded: there is no margin.
///
/// Certificate: "extreme_points": for each axis the place of a point of the `least` coordinate, and of one of the
/// `greatest`.
template <Exact Number = double>
Truth<Aabb2<Rational>> aabb_of_points(const std::vector<Point2<Number>>& points);
template <Exact Number = double>
Truth<Aabb3<Rational>> aabb_of_points(const std::vector<Point3<Number>>& points);

}  // namespace touchstone::oracle
