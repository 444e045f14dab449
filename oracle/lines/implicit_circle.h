// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: sign of |point - center|^2 - radius^2 on integers. Margin: its absolute value (a difference of squared
/// lengths).
Truth<Location> implicit_circle(const Circle2d& circle, const Point2d& point);
template <Exact Number>
Truth<Location> implicit_circle(const Circle2<Number>& circle, const Point2<Number>& point);

}  // namespace touchstone::oracle
