// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a triangle and an axis-aligned box are `disjoint`, only touch or overlap.
///
/// `overlapping`: the triangle contains an interior point of the box; `touching`: it contains a point of the box, but
/// none of its interior. A triangle without area is a segment or a point, and overlaps the box as any other does. A
/// flat box, min == max on an axis, has no interior: a triangle that meets it touches it, however deep. Right for all
/// finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so does min > max ("min <= max"). Contract: reference/mixed/triangle_aabb.h.
Contact triangle_aabb(const Triangle3d& triangle, const Aabb3d& aabb);

namespace stages {

struct triangle_aabb : Signatures<decltype(robust::triangle_aabb)> {
  static Partial filter, lattice;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
