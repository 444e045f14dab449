// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>

#include "catalogue/families/program_draws.h"

/// Programs whose queries have long replies, or replies in an order that rounding may change, drawn from a draw stream.
namespace touchstone::catalogue {

/// 17 to 64 bodies that have a square in common, x = 0 and y and z from 0 to 1, and queries there: all of them are in
/// the reply, but for some that were moved away. All pairs of so many bodies would be expensive.
inline Program many_answers(DrawStream& c) {
  Programming p(c);
  const auto body = [&c] {
    const auto out = [&c](std::uint64_t most) { return static_cast<double>(c.below(most)); };
    const double x = out(9), y = out(4), z = out(4), u = out(9), v = out(4), w = out(4);
    return Aabb3d{{-x, -y, -z}, {u, 1 + v, 1 + w}};
  };
  while (p.there().size() < 17 || (p.there().size() < 64 && c.below(16) != 0)) p.start_with(body());
  for (std::uint64_t left = c.below(3); left > 0; --left) p.move(shifted(body(), 20, 0, 0));
  for (std::uint64_t left = 1 + c.below(2); left > 0; --left) {
    const auto in_square = [&c] { return up_to(c, 2) / 2; };
    const double y = in_square(), z = in_square();
    switch (c.below(3)) {
      case 0: p.ask_in(body()); break;
      case 1: p.ask_at({0, y, z}); break;
      default: {
        const double from = c.one_in(4) ? 0 : -16;
        p.ask_along(c.coin() ? Ray3d{{-from, y, z}, {-1, 0, 0}} : Ray3d{{from, y, z}, {2, 0, 0}});
      }
    }
  }
  return p.program();
}

/// Boxes as wide as space that a ray enters across one axis each, at the time (n - 1) / n. For some axes n is greater
/// by 1 or 2, for some numerator and denominator have a common factor: the times are equal, or are not and round to the
/// same double, or their products with reciprocals do. An index that is greater may come first.
inline Program met_nearly_at_once(DrawStream& c) {
  Programming p(c);
  const double power = power_of_two(c, 2, 49), n = power + up_to(c, 7);
  const Point3d origin = lattice_point_of_box(c, 2);
  struct Axis {
    double Point3d::*position;
    double distance, speed;
  };
  std::array<Axis, 3> axes{{{&Point3d::x, 0, 0}, {&Point3d::y, 0, 0}, {&Point3d::z, 0, 0}}};
  for (Axis& axis : axes) {
    const double own = n + up_to(c, 2), factor = one_to(c, 3);
    const double side = either_sign(c) * factor;
    axis.distance = side * (own - 1), axis.speed = side * own;
  }
  for (std::uint64_t left = 2 + c.below(6); left > 0; --left) {
    Aabb3d box{{-0x1p60, -0x1p60, -0x1p60}, {0x1p60, 0x1p60, 0x1p60}};
    const Axis& axis = axes[c.below(3)];
    const double farther = c.one_in(4) ? small_integer(c, 1) : 0;
    Point3d& near_corner = axis.speed > 0 ? box.min : box.max;
    near_corner.*axis.position = origin.*axis.position + axis.distance + farther;
    p.start_with(box);
  }
  p.ask_along({origin, {axes[0].speed, axes[1].speed, axes[2].speed}});
  return p.program();
}

}  // namespace touchstone::catalogue
