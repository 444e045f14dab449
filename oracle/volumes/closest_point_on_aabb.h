// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/volumes.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the point of the box of least squared distance, a sum over the axes, so that on each the conditions of
/// Karush, Kuhn and Tucker find it (oracle/exact/numbers/nearest_in_interval.h). On integers. Nothing is decided, and
/// nothing is rounded: there is no margin.
///
/// Certificate: "multipliers": `lower` and `upper`, by axis; the conditions hold with them.
template <Exact Number = double>
Truth<Point2<Rational>> closest_point_on_aabb(const Point2<Number>& point, const Aabb2<Number>& aabb);
template <Exact Number = double>
Truth<Point3<Rational>> closest_point_on_aabb(const Point3<Number>& point, const Aabb3<Number>& aabb);

}  // namespace touchstone::oracle
