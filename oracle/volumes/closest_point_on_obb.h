// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/volumes.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the point of the parallelepiped, the hull of its corners, of least squared distance, in rationals, by the
/// conditions of Karush, Kuhn and Tucker (oracle/exact/shapes/nearest_pair.h). The distance is as
/// closest_point_on_segment has it. Nothing is decided: there is no margin.
///
/// Certificate: "root" or "irrational_root", as closest_point_on_segment has them; `coefficients` of the half axes.
template <Exact Number = double>
Truth<ClosestPoint3<Surd>> closest_point_on_obb(const Point3<Number>& point, const Obb3<Number>& obb);

}  // namespace touchstone::oracle
