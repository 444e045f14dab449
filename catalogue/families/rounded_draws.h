// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "catalogue/families/plane_draws.h"

/// Points whose differences are rounded by nearly a unit in the last place, all to the side that makes a determinant
/// wrong. With u that unit of 1, it is off by 5 u upwards (4 u where FMA leaves a product unrounded) and by 4 u
/// downwards; the bound of cross_sign (robust/kernel/filters/filters.h) is 6 u, half of it 3 u.
namespace touchstone::catalogue {

/// A point and, nearly opposite as seen from it, the ends of a segment.
struct RoundedTriple {
  Point2d seen_from, first, second;
};

/// On the line of the ends, or so near it that the determinant is between -u^2 and -u^2 / 2. Upwards errs most as it
/// stands, downwards when rotated by 180 degrees.
inline RoundedTriple rounded_triple(DrawStream& draws, bool on_line) {
  constexpr double u = 0x1p-52;
  const double least = std::ldexp(1, -107 - integer_in(draws, 0, 199));
  // (1 + dx)(1 + 2u + dy) - (1 + u - dy)(1 + u - dx) = (2 + 3u) dx + (2 + u) dy - u^2 is 0 for the greater two.
  const double dx = on_line ? 0x1p-106 * (1 + u) : least, dy = on_line ? 0x1p-106 * (1 - 3 * u) : least;
  const double turned = either_sign(draws);
  return {{-turned * dx, -turned * dy}, {turned, -turned * (1 + u)}, {-turned * (1 + u), turned * (1 + 2 * u)}};
}

}  // namespace touchstone::catalogue
