// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether an axis-aligned box and an oriented box, as closed solids, are `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point and no common interior point; so has a flat box, min == max on an axis, that
/// meets the other, however deep. The half axes need not be perpendicular: the oriented box is the parallelepiped that
/// they span, exactly. Right for all finite doubles in every floating-point environment. NaN and infinities throw
/// InvalidInput, which names the field and "finite number"; so do min > max ("min <= max") and half axes that are
/// linearly dependent ("obb.half_axes", "linearly independent"). Contract: reference/volumes/aabb_obb.h.
Contact aabb_obb(const Aabb3d& aabb, const Obb3d& obb);

namespace stages {

struct aabb_obb : Signatures<decltype(robust::aabb_obb)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
