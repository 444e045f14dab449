// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/interior_angles.h"

#include "robust/kernel/arc_tangent.h"
#include "robust/kernel/control_word.h"
#include "robust/kernel/integers.h"
#include "robust/lines/orientation.h"
#include "robust/rings/simple.h"

namespace touchstone::robust {
namespace {

/// Of a simple ring: its turn at the vertex that is lexicographically first, which is a corner of the hull.
bool counter_clockwise(const Polygon2d& ring) {
  std::size_t first = 0;
  const kernel::ControlWord ieee;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (ring[i].x < ring[first].x || (ring[i].x == ring[first].x && ring[i].y < ring[first].y)) first = i;
  }
  return orientation(ring.previous(first), ring[first], ring.next(first)) == Side::left;
}

/// From p -> from counter-clockwise to p -> to.
double angle(const Point2d& p, const Point2d& from, const Point2d& to) {
  const auto n = kernel::integers_of(p.x, p.y, from.x, from.y, to.x, to.y).at;
  const mpz_class vx = n[2] - n[0], vy = n[3] - n[1], wx = n[4] - n[0], wy = n[5] - n[1];
  return kernel::angle_rounded(vx * wx + vy * wy, vx * wy - vy * wx);
}

}  // namespace

std::vector<double> interior_angles(const Polygon2d& polygon) {
  validation::validate("polygon", polygon);
  if (const auto defect = ring_defect(polygon)) validation::refuse("polygon", *defect);
  const bool ccw = counter_clockwise(polygon);
  std::vector<double> angles;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2d &next = polygon.next(i), &previous = polygon.previous(i);
    angles.push_back(ccw ? angle(polygon[i], next, previous) : angle(polygon[i], previous, next));
  }
  return angles;
}

}  // namespace touchstone::robust
