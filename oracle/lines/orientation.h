// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/exact/systems/elimination.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: sign of the 3x3 determinant of the homogeneous points. Margin: its absolute value (twice the triangle's
/// area).
template <Exact Number = double>
Truth<Side> orientation(const Point2<Number>& p0, const Point2<Number>& p1, const Point2<Number>& p);

/// The answer of `orientation` alone by elimination (oracle/exact/systems/elimination.h), in 128-bit integers if the
/// coordinates allow it.
Side orientation_side(const Point2d& p0, const Point2d& p1, const Point2d& p);

}  // namespace touchstone::oracle
