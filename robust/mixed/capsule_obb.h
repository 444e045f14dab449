// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a capsule and an oriented box, as closed solids, are `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point and no common interior point: the capsule only reaches the box, or has the
/// radius 0. The half axes need not be perpendicular: the box is the parallelepiped that they span, exactly. Right for
/// all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field
/// and "finite number"; so do a negative radius ("radius >= 0") and half axes that are linearly dependent
/// ("obb.half_axes", "linearly independent"). Contract: reference/mixed/capsule_obb.h.
Contact capsule_obb(const Capsule3d& capsule, const Obb3d& obb);

namespace stages {

struct capsule_obb : Signatures<decltype(robust::capsule_obb)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
