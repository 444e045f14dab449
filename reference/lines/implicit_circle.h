// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"

namespace touchstone::reference {

/// Locates a point relative to the closed disc that a circle bounds.
///
/// Deck p. 8: x^2 + y^2 - r^2, here with the centre moved to the origin:
///     E = (x - cx)^2 + (y - cy)^2 - r^2;
/// inside where E < 0, outside where E > 0, boundary where E = 0. circle, point: any unit of length, the same for both.
/// Closed sets: `boundary` means exactly on the circle. A circle of radius 0 is its centre, which is all boundary. NaN
/// or infinity: refused by robust and oracle (field, "finite number"); so is a negative radius ("radius >= 0").
///
/// Rounding (binary64, to nearest, u = 2^-53): with A and B the two squares, S = A + B and R = r^2 as computed. Each of
/// A and B carries its difference's rounding twice and its own: off by at most ((1 + u)^3 - 1) A <= (3 + 4u) u A and,
/// where it underflows, (1 + u)^2 2^-1075. S adds u S to that, R is off by u R + 2^-1075, and A + B <= (1 + u) S. The
/// last subtraction keeps its sign. So the double version is right when |E| exceeds (4 + 8u) u S + u R + 2^-1073,
/// unless S or R overflows. In exact arithmetic the formula is always right. No number is returned.
template <class Real>
Location implicit_circle(const Circle2<Real>& circle, const Point2<Real>& point) {
  const Vector2<Real> d = point - circle.center;
  const Real e = Real(dot(d, d) - Real(circle.radius * circle.radius));
  return e < Real(0) ? Location::inside : e > Real(0) ? Location::outside : Location::boundary;
}

}  // namespace touchstone::reference
