// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: sign of the rational E = N . p + d. The distance is E / sqrt(N . N). Margin: E^2 / (N . N), the squared
/// distance. Certificate: "root" or, where the distance is not rational, "irrational_root"; the checker computes E and
/// N . N itself.
template <Exact Number = double>
Truth<PointPlane<Surd>> point_plane(const Plane<Number>& plane, const Point3<Number>& point);

}  // namespace touchstone::oracle
