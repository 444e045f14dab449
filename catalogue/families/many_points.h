// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/families/list_choices.h"
#include "catalogue/families/space_choices.h"

/// Long lists of points, drawn from a stream of choices.
namespace touchstone::catalogue {

/// Points near the origin, and one that is beyond them on every axis: without it the answer is another one.
inline std::vector<Point3d> many_points_and_one_far(Choices& choices) {
  std::vector<Point3d> points = long_list(choices, [](Choices& c) {
    const double x = small_integer(c), y = small_integer(c);
    return Point3d{x, y, small_integer(c)};
  });
  const auto far = [&choices] {
    const auto size = static_cast<double>(9 + choices.below(16));
    return choices.below(2) == 1 ? -size : size;
  };
  const double x = far(), y = far(), z = far();
  const std::size_t place = late_index(points.size(), choices);
  points[place] = {x, y, z};
  return points;
}

}  // namespace touchstone::catalogue
