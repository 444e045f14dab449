// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/numbers.h"
#include "geometry/points.h"

/// Points and vectors of the plane, drawn from a draw stream.
namespace touchstone::catalogue {

/// A lattice point of the plane, near the origin first.
inline Point2d lattice_point(DrawStream& draws, int bits = 26) {
  const double x = integer(draws, bits);
  return {x, integer(draws, bits)};
}

/// A lattice vector that is not zero; (1, 0) is the simplest.
inline Vector2d lattice_direction(DrawStream& draws, int bits = 20) {
  const double x = integer(draws, bits), y = integer(draws, bits);
  return x == 0 && y == 0 ? Vector2d{1, 0} : Vector2d{x, y};
}

/// p + t v; exact for the sizes that the two functions above and small t give.
inline Point2d along(const Point2d& p, double t, const Vector2d& v) { return {p.x + t * v.x, p.y + t * v.y}; }

}  // namespace touchstone::catalogue
