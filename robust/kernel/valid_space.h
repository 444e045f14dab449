// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/valid.h"

/// Whether shapes of space are valid; the rules are those of geometry/validation.h (see valid.h).
namespace touchstone::robust::kernel {

inline bool valid(const Point3d& p) { return all_finite(p.x, p.y, p.z); }
inline bool valid(const Plane3d& plane) {
  const auto& n = plane.normal;
  return all_finite(n.x, n.y, n.z, plane.offset) && !(validation::zero(n.x) && validation::zero(n.y) && validation::zero(n.z));
}

inline bool valid(const Vector3d& v) { return all_finite(v.x, v.y, v.z); }
inline bool valid(const Sphere3d& s) {
  return all_finite(s.center.x, s.center.y, s.center.z, s.radius) && !validation::negative(s.radius);
}

}  // namespace touchstone::robust::kernel
