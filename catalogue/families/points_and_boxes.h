// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <tuple>

#include "catalogue/families/round_draws.h"

/// Hard cases of a point and an oriented box.
namespace touchstone::catalogue {

using PointAndBox = std::tuple<Point3d, Obb3d>;

/// Half axes of which so many are at a right angle to the way to the point; each other one leads to it.
template <int across>
inline PointAndBox point_beyond(DrawStream& c) {
  const Step step = integer_step(c);
  Obb3d box{lattice_point_in_space(c, 16), {}};
  Point3d nearest = box.center;
  int k = 0;
  for (Vector3d* axis : each_of(box.half_axes)) {
    const double towards = k++ < across ? 0 : one_to(c, 3), share = towards == 0 ? small_integer(c, 2) : 2;
    *axis = 2 * towards * step.displacement + 2.0 * lattice_across(c, step.displacement);
    nearest = nearest + share / 2 * *axis;
  }
  if (volume_of(box.half_axes) == 0) box.half_axes = straight_half_axes(c);
  return {nearest + step.displacement, box};
}

/// Calls add(name, draw) for each.
template <class Add>
void add_points_and_boxes(const Add& add) {
  add("beyond_face", point_beyond<2>);
  add("beyond_edge", point_beyond<1>);
  add("beyond_corner", point_beyond<0>);
  add("near_boundary", [](DrawStream& c) -> PointAndBox {
    const Obb3d box{lattice_point_in_space(c, 20), c.coin() ? turned_half_axes(c) : skew_half_axes(c)};
    const Point3d p = on_obb(box, c);
    const double i = small_integer(c, 1), j = small_integer(c, 1), size = power_of_two(c, -30, 0);
    return {{p.x + i * size, p.y + j * size, p.z}, box};
  });
  add("halfway", [](DrawStream& c) -> PointAndBox {
    // Over a face along a diagonal: x and y of the foot are half a step further, x is halfway between two doubles.
    const double x = halfway_number(c), odd = 1 + 2 * up_to(c, 7), z = small_integer(c, 3);
    return {{x + odd, hair(c), z}, {{x + 31, 33, 0}, {{32, 32, 0}, {0, 0, 64}, {-1, 1, 0}}}};
  });
  add("halfway_distance", [](DrawStream& c) -> PointAndBox {
    const HalfwayStep step = halfway_step(c);
    return {{step.x, step.y, hair(c)}, {{-1, -1, 0}, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  });
  add_balls_and_boxes([&add]<class Draw>(const char* family, const Draw&) {
    const std::string_view name = family;
    if (name == "tangent" || name == "negative_radius") return;  // as above; the same points
    add(name == "point_ball" ? "in_or_beside" : family, [](DrawStream& c) -> PointAndBox {
      const auto [ball, box] = Draw()(c);
      return {ball.center, box};
    });
  });
}

}  // namespace touchstone::catalogue
