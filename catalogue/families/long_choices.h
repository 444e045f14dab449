// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "catalogue/families/plane_choices.h"

/// Points that lie exactly on one line although no difference of two of them is a double: where a filter sees a
/// position other than the true one, but not by much.
namespace touchstone::catalogue {

/// All 53 bits, 1 <= |x| < 2.
inline double long_number(Choices& choices) {
  const double x = 1 + std::ldexp(static_cast<double>(choices.below(std::uint64_t{1} << 52)), -52);
  return choices.below(2) == 1 ? -x : x;
}

inline Vector2d long_direction(Choices& choices) {
  const double x = long_number(choices);
  return {x, long_number(choices)};
}

/// Three points on one line through the origin, the third between the others. The differences from the first are about
/// as long as it, and none of them is a double: that is where an orientation is off most.
struct LongTriple {
  Point2d first, last, between;
};
inline LongTriple long_triple(Choices& choices) {
  const Vector2d v = long_direction(choices);
  const int last = 1 + static_cast<int>(choices.below(3)), between = last + 1 + static_cast<int>(choices.below(4));
  const double a = std::ldexp(-1, -last), b = std::ldexp(-1, -between);
  return {{v.x, v.y}, {a * v.x, a * v.y}, {b * v.x, b * v.y}};
}

}  // namespace touchstone::catalogue
