// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <vector>

#include "catalogue/families/hard_case.h"
#include "catalogue/families/space_draws.h"
#include "geometry/rays.h"

/// Shared by families of lines and solids.
namespace touchstone::catalogue {

/// Where a line starts and, at t = 1, is, or whereto a ray leads.
struct Course {
  Point3d from;
  Vector3d displacement;
};

/// Through x, or to it, or away from it: x is at t = 1 / 2, 1, 2, -1 or so, exactly.
inline Course course_through(DrawStream& c, const Point3d& x, const Vector3d& v) {
  const double before = small_integer(c, 2) + 1, length = one_to(c, 3);
  return {x + (-before) * v, length * v};
}

/// Many lengths of the direction away, where small differences cancel.
inline Course course_from_afar(DrawStream& c, const Point3d& x, const Vector3d& v) {
  const double far = power_of_two(c, 20, 43);
  const bool long_way = c.coin();
  return {x + (-far) * v, (long_way ? 2 * far : 1) * v};
}

/// Any size of direction, past every guard.
inline Vector3d of_any_size(DrawStream& c, const Vector3d& v) { return scaled(v, integer_in(c, -1060, 979)); }

/// The question in space, or the same without z.
template <class Row, class Solid>
typename Row::Question in_either(DrawStream& c, const Course& course, const Solid& solid) {
  return Row::of(course, solid, c.coin());
}

}  // namespace touchstone::catalogue
