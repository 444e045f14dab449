// SPDX-License-Identifier: Apache-2.0
#include "robust/batch/orientation.h"

#include <string>

#include "geometry/invalid_input.h"
#include "robust/lines/orientation.h"

namespace touchstone::robust::batch {

void orientation(const Points2& p0, const Points2& p1, const Points2& p, std::size_t count, std::uint8_t* sides) {
  const auto at = [](const Points2& points, std::size_t i) { return Point2d{points.x[i], points.y[i]}; };
  for (std::size_t i = 0; i < count; ++i) {
    try {
      sides[i] = static_cast<std::uint8_t>(robust::orientation(at(p0, i), at(p1, i), at(p, i)));
    } catch (const InvalidInput& refused) {
      throw InvalidInput("questions[" + std::to_string(i) + "]." + refused.field(), refused.rule());
    }
  }
}

}  // namespace touchstone::robust::batch
