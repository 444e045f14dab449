// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// Decides on which side of the directed line p0 -> p1 the point p lies (y up: `left` is counter-clockwise).
///
/// Deck p. 16-17:
///     E = (y - y0)(x1 - x0) - (x - x0)(y1 - y0);
/// left where E > 0, right where E < 0, on where E = 0.
/// p0, p1, p: any unit of length, the same for all. p0 == p1 is valid and answers `on` for every p.
/// Closed sets: `on` means exactly on the line, however near the others are.
/// NaN or infinity: refused by robust and oracle (field, "finite number").
///
/// Rounding (binary64, to nearest, u = 2^-53): with L = (y - y0)(x1 - x0) and R = (x - x0)(y1 - y0) as computed, the
/// computed E is off by at most (3 + 16u) u (|L| + |R|) + 2^-1073 unless something overflows, because each product
/// carries two rounded differences and its own rounding, the last subtraction one more, and gradual underflow costs
/// half of 2^-1074 a product. Beyond that margin the double version is right. In exact arithmetic the formula is always
/// right.
template <class Real>
Side orientation(const Point2<Real>& p0, const Point2<Real>& p1, const Point2<Real>& p) {
  const Real e = Real((p.y - p0.y) * (p1.x - p0.x)) - Real((p.x - p0.x) * (p1.y - p0.y));
  return e > Real(0) ? Side::left : e < Real(0) ? Side::right : Side::on;
}

}  // namespace touchstone::reference
