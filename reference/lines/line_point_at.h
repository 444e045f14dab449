// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// The point of a parametric line at the parameter t.
///
/// Deck p. 9:
///     P(t) = P0 + t V.
/// line.origin and line.direction: any unit of length, the same for both; t: a pure number, any sign, in units of the
/// direction's length. The line is unbounded, so there is nothing open or closed about it. NaN or infinity: refused by
/// robust and oracle (field, "finite number"); so is a zero direction ("nonzero direction").
///
/// Rounding (binary64, to nearest, u = 2^-53): with P = t V.x and X = P0.x + P as computed, x is off by at most u |P| +
/// 2^-1075 for the product and u |X| for the sum, unless one of them overflows; y likewise. Nothing is decided, so this
/// holds for every input: there is no margin. In exact arithmetic the formula is always right. ulps: 2 roundings behind
/// each coordinate (product, sum).
template <class Real>
Point2<Real> line_point_at(const ParametricLine2<Real>& line, const Real& t) {
  return line.origin + t * line.direction;
}

}  // namespace touchstone::reference
