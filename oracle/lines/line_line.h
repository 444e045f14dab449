// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: each line as the cross product of its two homogeneous points, the common point as the cross product of the
/// two lines: a last coordinate of 0 is `parallel`, all three 0 is `same`. Margin: the absolute cross product of the
/// two directions (the area of their parallelogram), so 0 for `parallel` and `same`.
template <Exact Number = double>
Truth<LineLine<Rational>> line_line(const Line2<Number>& a, const Line2<Number>& b);

}  // namespace touchstone::oracle
