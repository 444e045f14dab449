// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/volumes.h"
#include "robust/kernel/filters/ordered_bits.h"

/// Valid boxes compared by the order of their bits: right in every floating-point environment.
namespace touchstone::robust::structures {

inline bool not_above(double a, double b) { return kernel::ordered_bits(a) <= kernel::ordered_bits(b); }

inline bool meet(const Aabb3d& a, const Aabb3d& b) {
  return not_above(a.min.x, b.max.x) && not_above(b.min.x, a.max.x) && not_above(a.min.y, b.max.y) &&
         not_above(b.min.y, a.max.y) && not_above(a.min.z, b.max.z) && not_above(b.min.z, a.max.z);
}

/// The least box that contains both.
inline Aabb3d around(const Aabb3d& a, const Aabb3d& b) {
  const auto least = [](double p, double q) { return not_above(p, q) ? p : q; };
  const auto most = [](double p, double q) { return not_above(p, q) ? q : p; };
  return {{least(a.min.x, b.min.x), least(a.min.y, b.min.y), least(a.min.z, b.min.z)},
          {most(a.max.x, b.max.x), most(a.max.y, b.max.y), most(a.max.z, b.max.z)}};
}

inline bool same(const Aabb3d& a, const Aabb3d& b) {
  const auto equal = [](double p, double q) { return not_above(p, q) && not_above(q, p); };
  return equal(a.min.x, b.min.x) && equal(a.min.y, b.min.y) && equal(a.min.z, b.min.z) && equal(a.max.x, b.max.x) &&
         equal(a.max.y, b.max.y) && equal(a.max.z, b.max.z);
}

/// An eighth of the sum of its widths, which does not overflow: an estimate.
inline double size(const Aabb3d& box) {
  const auto width = [](double low, double high) { return 0.125 * high - 0.125 * low; };
  return width(box.min.x, box.max.x) + width(box.min.y, box.max.y) + width(box.min.z, box.max.z);
}

}  // namespace touchstone::robust::structures
