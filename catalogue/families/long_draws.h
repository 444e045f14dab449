// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "catalogue/families/plane_draws.h"

/// Points that lie exactly on one line although no difference of two of them is a double: where a filter sees a
/// position other than the true one, but not by much.
namespace touchstone::catalogue {

/// All 53 bits, 1 <= |x| < 2.
inline double long_number(DrawStream& draws) {
  const double x = 1 + std::ldexp(static_cast<double>(draws.below(std::uint64_t{1} << 52)), -52);
  return either_sign(draws) * x;
}

inline Vector2d long_direction(DrawStream& draws) { return {long_number(draws), long_number(draws)}; }

/// Three points on one line through the origin, the third between the others. The differences from the first are about
/// as long as it, and none of them is a double: that is where an orientation is off most.
struct LongTriple {
  Point2d first, last, between;
};
inline LongTriple long_triple(DrawStream& draws) {
  const Vector2d v = long_direction(draws);
  const int last = integer_in(draws, 1, 3), between = last + integer_in(draws, 1, 4);
  const double a = std::ldexp(-1, -last), b = std::ldexp(-1, -between);
  return {{v.x, v.y}, {a * v.x, a * v.y}, {b * v.x, b * v.y}};
}

}  // namespace touchstone::catalogue
