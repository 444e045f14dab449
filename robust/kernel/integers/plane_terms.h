// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/space.h"
#include "robust/kernel/integers/term_sum.h"

/// Functions of a plane and a point, as sums of terms.
namespace touchstone::robust::kernel {

/// N . p + d
inline std::array<Term, 4> height_over(const Plane3d& plane, const Point3d& p) {
  const Vector3d& n = plane.normal;
  return {term(n.x, p.x), term(n.y, p.y), term(n.z, p.z), term(plane.offset)};
}

/// N . N
inline std::array<Term, 3> squared_normal(const Plane3d& plane) {
  const Vector3d& n = plane.normal;
  return {term(n.x, n.x), term(n.y, n.y), term(n.z, n.z)};
}

}  // namespace touchstone::robust::kernel
