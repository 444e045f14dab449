// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// Decides whether a point lies above, on or below the line y = slope x + intercept (y up).
///
/// Deck p. 8:
///     E = y - (m x + b);
/// above where E > 0, below where E < 0, on where E = 0.
/// intercept, point: any unit of length, the same for both; slope: a ratio of lengths. No vertical line has this form.
/// Closed sets: `on` means exactly on the line, however near the others are. A slope of 0 is valid.
/// NaN or infinity: refused by robust and oracle (field, "finite number").
///
/// Rounding (binary64, to nearest, u = 2^-53): with P = m x and S = P + b as computed, the product is off by at most u
/// |P| + 2^-1075 (half of the least subnormal, where it underflows) and the sum by u |S|; the last subtraction rounds,
/// but keeps its sign. So the double version is right when |E| exceeds u (|P| + |S|) + 2^-1075, unless P or S
/// overflows. In exact arithmetic the formula is always right. No number is returned.
template <class Real>
Height explicit_line(const Real& slope, const Real& intercept, const Point2<Real>& point) {
  const Real e = Real(point.y - Real(Real(slope * point.x) + intercept));
  return e > Real(0) ? Height::above : e < Real(0) ? Height::below : Height::on;
}

}  // namespace touchstone::reference
