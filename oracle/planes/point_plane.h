// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: sign of the rational E = N . p + d. The distance is the root of E^2 / (N . N) by exact comparison of squares:
/// rational where that is a square, otherwise a rational that has the same nearest double (and sign) and is within
/// 2^-60 units in the last place. Margin: E^2 / (N . N), the squared distance.
Truth<PointPlane<Rational>> point_plane(const Plane3d& plane, const Point3d& point);
template <Exact Number>
Truth<PointPlane<Rational>> point_plane(const Plane<Number>& plane, const Point3<Number>& point);

}  // namespace touchstone::oracle
