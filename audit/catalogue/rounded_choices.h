// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "audit/catalogue/row.h"

/// Points whose differences, rounded upwards, are off by nearly a unit in the last place, and all to the side that makes a determinant
/// wrong: by 5 units of its last place, where a filter's bound is 6 (robust/kernel/filters.h) and half of it 3.
namespace touchstone::audit {

/// A point and, nearly opposite as seen from it, the ends of a segment.
struct RoundedTriple {
  Point2d seen_from, first, second;
};

/// On the line of the ends, or beside it by less than any difference shows. Turned by 180 degrees it is rounding downwards that errs.
inline RoundedTriple rounded_triple(Choices& choices) {
  constexpr double u = 0x1p-52;
  const double least = std::ldexp(1, -107 - static_cast<int>(choices.below(200)));
  const bool on_line = choices.below(2) == 1;
  // (1 + dx)(1 + 2u + dy) - (1 + u - dy)(1 + u - dx) = (2 + 3u) dx + (2 + u) dy - u^2 is 0 for the greater two.
  const double dx = on_line ? 0x1p-106 * (1 + u) : least, dy = on_line ? 0x1p-106 * (1 - 3 * u) : least;
  const double side = choices.below(2) == 1 ? -1 : 1;
  return {{-side * dx, -side * dy}, {side, -side * (1 + u)}, {-side * (1 + u), side * (1 + 2 * u)}};
}

}  // namespace touchstone::audit
