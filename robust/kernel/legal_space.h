// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "robust/kernel/legal.h"

/// Whether the door admits shapes of space; the rules are the door's (see legal.h).
namespace touchstone::robust::kernel {

inline bool legal(const Point3d& p) { return all_finite(p.x, p.y, p.z); }
inline bool legal(const Plane3d& plane) {
  const auto& n = plane.normal;
  return all_finite(n.x, n.y, n.z, plane.offset) && !(door::zero(n.x) && door::zero(n.y) && door::zero(n.z));
}

}  // namespace touchstone::robust::kernel
