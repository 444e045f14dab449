// SPDX-License-Identifier: Apache-2.0
#include "robust/polygons/interior_angles.h"

#include "robust/kernel/enclosed/enclosed_shapes.h"
#include "robust/kernel/filters/control_word.h"
#include "robust/kernel/integers/arc_tangent.h"
#include "robust/kernel/integers/enclosed_angles.h"
#include "robust/kernel/integers/integers.h"
#include "robust/lines/orientation.h"
#include "robust/rings/simple.h"

namespace touchstone::robust {
namespace {

/// The orientation of a simple ring: its turn at the lexicographically first vertex, which is a corner of the hull.
bool counter_clockwise(const Polygon2d& ring) {
  std::size_t first = 0;
  const kernel::ControlWord ieee;
  for (std::size_t i = 1; i < ring.size(); ++i) {
    if (ring[i].x < ring[first].x || (ring[i].x == ring[first].x && ring[i].y < ring[first].y)) first = i;
  }
  return orientation(ring.previous(first), ring[first], ring.next(first)) == Side::left;
}

/// The angle from p -> from counter-clockwise to p -> to.
std::optional<double> enclosed_angle(const Point2d& p, const Point2d& from, const Point2d& to) {
  using namespace kernel;
  const Two at(p), first(from), last(to);
  if (!in_window(at, first, last)) return std::nullopt;
  const Factor<Two> v = vector_between(at, first), w = vector_between(at, last);
  const auto angle = kernel::enclosed_angle(enclosed_dot(v, w), enclosed_cross(v, w));
  return angle ? rounded(*angle) : std::nullopt;
}

double exact_angle(const Point2d& p, const Point2d& from, const Point2d& to) {
  const auto n = kernel::integers_of(p.x, p.y, from.x, from.y, to.x, to.y).at;
  const mpz_class vx = n[2] - n[0], vy = n[3] - n[1], wx = n[4] - n[0], wy = n[5] - n[1];
  return kernel::angle_rounded(vx * wx + vy * wy, vx * wy - vy * wx);
}

}  // namespace

std::vector<double> interior_angles(const Polygon2d& given) {
  validation::validate("polygon", given);
  const validation::OpenRing open(given);
  const Polygon2d& polygon = *open;
  if (const auto defect = ring_defect(polygon)) validation::refuse("polygon", *defect, polygon.size());
  const bool ccw = counter_clockwise(polygon), to_nearest = kernel::rounds_to_nearest();
  std::vector<double> angles;
  angles.reserve(polygon.size());
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2d &next = polygon.next(i), &previous = polygon.previous(i);
    const Point2d &from = ccw ? next : previous, &to = ccw ? previous : next;
    const auto enclosed = to_nearest ? enclosed_angle(polygon[i], from, to) : std::nullopt;
    angles.push_back(enclosed ? *enclosed : exact_angle(polygon[i], from, to));
  }
  return angles;
}

}  // namespace touchstone::robust
