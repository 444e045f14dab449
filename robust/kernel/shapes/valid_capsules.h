// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/validation_of_capsules.h"
#include "robust/kernel/shapes/valid_space.h"

/// Checks whether segments, triangles and capsules of space are valid (see valid.h).
namespace touchstone::robust::kernel {

inline bool valid(const Segment3d& s) { return valid(s.a) && valid(s.b); }
inline bool valid(const Triangle3d& t) { return valid(t.a) && valid(t.b) && valid(t.c); }
inline bool valid(const Capsule3d& c) {
  return valid(c.segment) && validation::finite(c.radius) && !validation::negative(c.radius);
}

}  // namespace touchstone::robust::kernel
