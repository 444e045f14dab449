// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "geometry/answers.h"

namespace touchstone::reference {

/// The point of a circle at the angle u.
///
/// Deck p. 8: (r cos u, r sin u), moved to the centre:
///     P(u) = (cx + r cos(u), cy + r sin(u)).
/// circle: any unit of length; u: radians, counter-clockwise from the +x axis (y up), of any size. The curve is the
/// circle itself, so there is nothing open or closed about it. Radius 0 is valid: the centre for every u. NaN or
/// infinity: refused by robust and oracle (field, "finite number"); so is a negative radius ("radius >= 0").
///
/// Rounding (binary64, to nearest, w = 2^-53): let the library's cosine C be off by at most one unit in its last place,
/// that is by 2w |C| + 2^-1074 (glibc's manual states one unit for binary64). The product P = r C adds w |P| + 2^-1075,
/// the sum X adds w |X|, and r |C| <= (1 + w) |P| + 2^-1075: together x is off by at most
///     (3 + 2w) w |P| + w |X| + (r + 1) 2^-1074
/// unless r C or the sum overflows; y likewise with the sine. Nothing is decided, so this holds for every input: there
/// is no margin. In exact arithmetic the formula is always right. ulps: 3 roundings behind each coordinate (cosine or
/// sine, product, sum).
template <class Real>
Point2<Real> parametric_circle(const Circle2<Real>& circle, const Real& u) {
  using std::cos, std::sin;
  return {Real(circle.center.x + Real(circle.radius * Real(cos(u)))),
          Real(circle.center.y + Real(circle.radius * Real(sin(u))))};
}

}  // namespace touchstone::reference
