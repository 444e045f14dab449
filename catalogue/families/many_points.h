// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "catalogue/families/list_draws.h"
#include "catalogue/families/space_draws.h"

/// Long lists of points, drawn from a draw stream.
namespace touchstone::catalogue {

/// Points near the origin, and one that is beyond them on every axis: without it the answer is another one.
inline std::vector<Point3d> many_points_and_one_far(DrawStream& draws) {
  std::vector<Point3d> points =
      long_list(draws, [](DrawStream& c) { return point_of(c, [](DrawStream& d) { return small_integer(d); }); });
  const auto far = [&draws] {
    const auto size = static_cast<double>(9 + draws.below(16));
    return either_sign(draws) * size;
  };
  const double x = far(), y = far(), z = far();
  const std::size_t place = late_index(points.size(), draws);
  points[place] = {x, y, z};
  return points;
}

}  // namespace touchstone::catalogue
