// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <tuple>

#include "catalogue/families/numbers.h"
#include "geometry/space.h"

/// Exact integers of space, drawn from a draw stream; the simplest first.
namespace touchstone::catalogue {

/// A lattice point of space, near the origin first.
inline Point3d lattice_point_in_space(DrawStream& draws, int bits = 26) {
  const double x = integer(draws, bits), y = integer(draws, bits);
  return {x, y, integer(draws, bits)};
}

/// A lattice vector that is not zero; (0, 1, 0) is the simplest.
inline Vector3d lattice_normal(DrawStream& draws, int bits = 20) {
  const double x = integer(draws, bits), y = integer(draws, bits), z = integer(draws, bits);
  return x == 0 && y == 0 && z == 0 ? Vector3d{0, 1, 0} : Vector3d{x, y, z};
}

/// A lattice vector at a right angle to n, perhaps zero: n x (small integers).
inline Vector3d lattice_across(DrawStream& draws, const Vector3d& n) {
  const double x = small_integer(draws), y = small_integer(draws), z = small_integer(draws);
  return cross(n, Vector3d{x, y, z});
}

/// A normal whose length is an integer; (0, 1, 0) is the simplest.
struct WholeNormal {
  Vector3d n;
  double length;
};
inline WholeNormal whole_normal(DrawStream& draws) {
  static constexpr WholeNormal normals[]{
      {{0, 1, 0}, 1}, {{1, 2, 2}, 3}, {{3, 4, 0}, 5}, {{2, 3, 6}, 7}, {{1, 4, 8}, 9}};
  return normals[draws.below(5)];
}

/// Three products of about half of the least subnormal number each, and an offset of one to three times that number.
inline std::tuple<Plane3d, Point3d> terms_below_least(DrawStream& draws) {
  const int k = integer_in(draws, -500, 499);
  const double a = std::ldexp(8 + up_to(draws, 7), k), b = std::ldexp(8 + up_to(draws, 7), -1082 - k);
  return {{{a, a, a}, -std::ldexp(one_to(draws, 3), -1074)}, {b, b, b}};
}

}  // namespace touchstone::catalogue
