// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "catalogue/families/numbers.h"
#include "geometry/thin_shapes.h"

/// Points and vectors of the plane, drawn from a draw stream.
namespace touchstone::catalogue {

/// A lattice point of the plane, near the origin first.
inline Point2d lattice_point(DrawStream& draws, int bits = 26) { return {integer(draws, bits), integer(draws, bits)}; }

/// A lattice vector that is not zero; (1, 0) is the simplest.
inline Vector2d lattice_direction(DrawStream& draws, int bits = 20) {
  const double x = integer(draws, bits), y = integer(draws, bits);
  return x == 0 && y == 0 ? Vector2d{1, 0} : Vector2d{x, y};
}

/// A lattice point and a direction from there.
inline Ray2d lattice_line(DrawStream& draws, int bits = 26, int bits_of_direction = 20) {
  return {lattice_point(draws, bits), lattice_direction(draws, bits_of_direction)};
}

/// p + t v; exact for the sizes that the two functions above and small t give.
inline Point2d along(const Point2d& p, double t, const Vector2d& v) { return {p.x + t * v.x, p.y + t * v.y}; }

}  // namespace touchstone::catalogue
