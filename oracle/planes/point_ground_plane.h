// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: sign of the rational N . p + d of the plane with N = (0, 1, 0), d = 0. Margin: its absolute value, the
/// distance from the ground.
template <Exact Number = double>
Truth<Height> point_ground_plane(const Point3<Number>& point);

}  // namespace touchstone::oracle
