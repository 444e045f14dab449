// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/orientation.h"

#include <algorithm>
#include <string>

#include "geometry/invalid_input.h"
#include "robust/lines/orientation.h"

namespace touchstone::robust::batch {
namespace {

/// As many questions as are filtered before those that the filter left open are asked one by one.
constexpr std::size_t block = 256;

Point2d at(const Points2& points, std::size_t i) { return {points.x[i], points.y[i]}; }

/// What the filter leaves open.
constexpr std::uint8_t open = 3;

std::uint8_t filtered(const Point2d& p0, const Point2d& p1, const Point2d& p) {
  const filters::Sign sign = filters::orientation(p0, p1, p);
  if (sign == filters::Sign::unknown) return open;
  return static_cast<std::uint8_t>(sign == filters::Sign::positive ? Side::left : Side::right);
}

}  // namespace

void orientation(const Points2& p0, const Points2& p1, const Points2& p, std::size_t count, std::uint8_t* sides) {
  for (std::size_t first = 0; first < count; first += block) {
    const std::size_t size = std::min(block, count - first);
    for (std::size_t i = first; i < first + size; ++i) sides[i] = filtered(at(p0, i), at(p1, i), at(p, i));
    for (std::size_t i = first; i < first + size; ++i) {
      if (sides[i] != open) continue;
      try {
        sides[i] = static_cast<std::uint8_t>(stages::orientation::past_filter(at(p0, i), at(p1, i), at(p, i)).answer);
      } catch (const InvalidInput& refused) {
        throw InvalidInput("questions[" + std::to_string(i) + "]." + refused.field(), refused.rule());
      }
    }
  }
}

}  // namespace touchstone::robust::batch
