// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the rational line E(t) = E0 + t N . (end - start): where it is at most 0 at t = 0, at its zero, at t = 1; the
/// point by t along the step. Margin: the squared distance from the plane of the point that decides: the end, and where
/// the end is in front the nearer of start and end.
template <Exact Number = double>
Truth<PointPlaneToi<Rational>> point_plane_toi(const Plane<Number>& plane, const Point3<Number>& start,
                                               const Point3<Number>& end);

}  // namespace touchstone::oracle
