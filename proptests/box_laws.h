// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "proptests/forward_error.h"

/// Laws of oriented boxes.
namespace touchstone::proptests {

/// The eight corners; exact on the lattice.
inline std::vector<Point3d> corners(const Obb3d& box) {
  const auto& [u, v, w] = box.half_axes;
  std::vector<Point3d> all;
  for (const double r : {-1.0, 1.0})
    for (const double s : {-1.0, 1.0})
      for (const double t : {-1.0, 1.0}) all.push_back(box.center + (r * u + (s * v + t * w)));
  return all;
}

/// A box along the axes, its half axes of the lengths of the diagonal of a box's, as both kinds; exact on the lattice.
/// None if it is flat.
struct Straight {
  Obb3d obb;
  Aabb3d aabb;
};
inline std::optional<Straight> straightened(const Obb3d& box) {
  const auto& [u, v, w] = box.half_axes;
  const Point3d& c = box.center;
  if (u.x == 0 || v.y == 0 || w.z == 0) return std::nullopt;
  const double x = std::fabs(u.x), y = std::fabs(v.y), z = std::fabs(w.z);
  return Straight{{c, {{u.x, 0, 0}, {0, v.y, 0}, {0, 0, w.z}}},
                  {{c.x - x, c.y - y, c.z - z}, {c.x + x, c.y + y, c.z + z}}};
}

/// The question with the half axes of the box that is its part of that number exchanged and one reversed.
template <std::size_t part, class Asked>
Asked in_another_order(Asked asked) {
  auto& [u, v, w] = std::get<part>(asked).half_axes;
  std::get<part>(asked).half_axes = {w, {-u.x, -u.y, -u.z}, v};
  return asked;
}

}  // namespace touchstone::proptests
