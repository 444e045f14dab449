// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <vector>

#include "programs.h"

/// Programs of space for engines of the plane.
namespace touchstone::programs {

template <class Real>
using Axis = Real Point3<Real>::*;

/// The two axes that decide, where on the third all boxes, those of queries too, have a number in common: then boxes
/// meet where their rectangles do. Empty where there is no such axis, and where the program has a ray.
template <class Real>
std::optional<std::pair<Axis<Real>, Axis<Real>>> deciding_axes(const std::vector<Aabb3<Real>>& boxes,
                                                               const std::vector<Command<Real>>& commands) {
  if (has<AlongRay<Real>>(commands)) return std::nullopt;
  const Axis<Real> x = &Point3<Real>::x, y = &Point3<Real>::y, z = &Point3<Real>::z;
  const auto decides_nothing = [&](Axis<Real> axis) {
    std::optional<Real> last_min, first_max;
    all_boxes(boxes, commands, [&](const Aabb3<Real>& box) {
      last_min = std::max(last_min.value_or(box.min.*axis), box.min.*axis);
      first_max = std::min(first_max.value_or(box.max.*axis), box.max.*axis);
      return true;
    });
    return !last_min || *last_min <= *first_max;
  };
  if (decides_nothing(z)) return std::pair{x, y};
  if (decides_nothing(y)) return std::pair{x, z};
  if (decides_nothing(x)) return std::pair{y, z};
  return std::nullopt;
}

}  // namespace touchstone::programs
