// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "simulate/world/world.h"

namespace touchstone::simulate {

/// The approximate contact point of two solids, in doubles, for drawings: on a sphere against the normal; between boxes
/// the middle of their intersection; for a box at a wall, its lowest corner.
template <class By>
Point3d drawn_point(const World<By>& world, const Touch& touch, const State<typename By::Number>& at,
                    const Vector3d& normal) {
  using Real = typename By::Number;
  const auto number = [](const Real& x) {
    if constexpr (std::is_same_v<Real, Exact>) return catalogue::nearest(x.value());
    else return static_cast<double>(x);
  };
  const auto along_normal = [&](std::size_t body, double sign) {
    const Point3d p = catalogue::converted<double>(at[body].position, number);
    const double reach = sign * number(world.solid(body).radius) / std::sqrt(dot(normal, normal));
    return Point3d{p.x + reach * normal.x, p.y + reach * normal.y, p.z + reach * normal.z};
  };
  const auto& first = world.solid(touch.body);
  if (first.shape != Shape::box && (touch.wall || first.shape == Shape::sphere)) return along_normal(touch.body, -1);
  if (!touch.wall && world.solid(touch.other).shape != Shape::box) return along_normal(touch.other, 1);
  const auto middle = [&](Real Point3<Real>::*axis, Real Vector3<Real>::*half, double n) {
    const double x = number(at[touch.body].position.*axis), r = number(first.half_extents.*half);
    if (touch.wall) return n > 0 ? x - r : x + r;
    const double y = number(at[touch.other].position.*axis), s = number(world.solid(touch.other).half_extents.*half);
    return (std::max(x - r, y - s) + std::min(x + r, y + s)) / 2;
  };
  return {middle(&Point3<Real>::x, &Vector3<Real>::x, normal.x), middle(&Point3<Real>::y, &Vector3<Real>::y, normal.y),
          middle(&Point3<Real>::z, &Vector3<Real>::z, normal.z)};
}

}  // namespace touchstone::simulate
