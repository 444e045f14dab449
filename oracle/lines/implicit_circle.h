// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: sign of |point - center|^2 - radius^2 on integers. Margin: its absolute value (a difference of squared
/// lengths).
template <Exact Number = double>
Truth<Location> implicit_circle(const Circle2<Number>& circle, const Point2<Number>& point);

}  // namespace touchstone::oracle
