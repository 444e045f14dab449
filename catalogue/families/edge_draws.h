// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <tuple>

#include "catalogue/families/box_draws.h"
#include "catalogue/families/triangle_draws.h"

/// Edges that cross edges, drawn from a draw stream.
namespace touchstone::catalogue {

/// A triangle of which one edge passes an edge of the box. At no distance they have one point in common, within both
/// edges, so that the cross product of the two is the only axis along which they touch; the distance is so small that
/// it also is the only one that separates them. `steep`: along the box's edge, the triangle's is 2^steep times as long
/// as across it. The box's edge is any of the twelve, the triangle's any of the three.
inline std::tuple<Triangle3d, Aabb3d> edge_over_edge(DrawStream& draws, int steep) {
  // Here the box's edge is parallel to z, at x = y = 0, the greatest of the box.
  const double x = one_to(draws, 4), y = one_to(draws, 4), length = std::ldexp(one_to(draws, 3), steep);
  const Vector3d edge{x, -y, either_sign(draws) * length}, outwards{y, x, 0};
  const double distance = std::ldexp(std::array{0.0, 1.0, 1.0, -1.0}[draws.below(4)], -6 - steep);
  const Point3d over = Point3d{0, 0, 0} + distance * outwards;
  const double before = one_to(draws, 3), after = one_to(draws, 3), beside = small_integer(draws) / 8,
               out = one_to(draws, 8);
  Triangle3d t{along(over, -before, edge), along(over, after, edge), along(over, beside, edge)};
  t.c = along(t.c, out, outwards);
  const auto width = [&draws] { return 5 + up_to(draws, 7); };
  const double u = width(), v = width(), below = width(), above = width();
  Aabb3d box{{-u, -v, -below}, {0, 0, above}};
  const std::uint64_t turns = draws.below(3), mirrored = draws.below(8);
  const Vector3d by = lattice_normal(draws, 8);
  for (Point3d* p : {&t.a, &t.b, &t.c, &box.min, &box.max}) {
    for (std::uint64_t left = turns; left > 0; --left) *p = {p->y, p->z, p->x};
    if ((mirrored & 1) != 0) p->x = -p->x;
    if ((mirrored & 2) != 0) p->y = -p->y;
    if ((mirrored & 4) != 0) p->z = -p->z;
    *p = *p + by;
  }
  put_in_order(box);
  return {in_some_order(t, draws), box};
}

}  // namespace touchstone::catalogue
