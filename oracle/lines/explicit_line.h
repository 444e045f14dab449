// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: sign of the rational y - (slope x + intercept). Margin: its absolute value (the vertical distance).
template <Exact Number = double>
Truth<Height> explicit_line(const Number& slope, const Number& intercept, const Point2<Number>& point);

}  // namespace touchstone::oracle
