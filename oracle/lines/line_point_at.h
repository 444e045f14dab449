// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: origin + t direction in rationals. Nothing is decided but the rounding: the margin is the smaller of the two
/// coordinates' distances, in their units in the last place, to the nearest tie between doubles.
template <Exact Number = double>
Truth<Point2<Rational>> line_point_at(const ParametricLine2<Number>& line, const Number& t);

}  // namespace touchstone::oracle
