// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/filters/ordered_bits.h"
#include "robust/kernel/shapes/valid.h"

/// Checks whether shapes of space, and boxes of the plane, are valid; the rules are those of geometry/validation.h (see
/// valid.h).
namespace touchstone::robust::kernel {

inline bool valid(const Point3d& p) { return all_finite(p.x, p.y, p.z); }
inline bool valid(const Plane3d& plane) {
  const auto& n = plane.normal;
  return all_finite(n.x, n.y, n.z, plane.offset) &&
         !(validation::zero(n.x) && validation::zero(n.y) && validation::zero(n.z));
}

inline bool valid(const Vector3d& v) { return all_finite(v.x, v.y, v.z); }
inline bool valid(const Sphere3d& s) {
  return all_finite(s.center.x, s.center.y, s.center.z, s.radius) && !validation::negative(s.radius);
}

inline bool in_order(double min, double max) { return ordered_bits(min) <= ordered_bits(max); }
inline bool valid(const Aabb2d& box) {
  return valid(box.min) && valid(box.max) && in_order(box.min.x, box.max.x) && in_order(box.min.y, box.max.y);
}
inline bool valid(const Aabb3d& box) {
  return valid(box.min) && valid(box.max) && in_order(box.min.x, box.max.x) && in_order(box.min.y, box.max.y) &&
         in_order(box.min.z, box.max.z);
}

/// Does not check that the half axes are independent, which takes a determinant.
inline bool valid(const Obb3d& box) {
  return valid(box.center) && valid(box.half_axes.u) && valid(box.half_axes.v) && valid(box.half_axes.w);
}
inline bool valid_normal(const Vector3d& n) {
  return valid(n) && (!validation::zero(n.x) || !validation::zero(n.y) || !validation::zero(n.z));
}
inline bool valid(const Slabd& slab) { return all_finite(slab.min, slab.max) && in_order(slab.min, slab.max); }
inline bool valid(const Kdop3d& kdop) {
  if (kdop.normals.empty() || kdop.slabs.size() != kdop.normals.size()) return false;
  for (std::size_t i = 0; i < kdop.normals.size(); ++i)
    if (!valid_normal(kdop.normals[i]) || !valid(kdop.slabs[i])) return false;
  return true;
}

}  // namespace touchstone::robust::kernel
