// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a ball and an oriented box, as closed solids, are `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point and no common interior point: the ball only reaches the box, or has the radius
/// 0. The half axes need not be perpendicular: the box is the parallelepiped that they span, exactly. Right for all
/// finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so do a negative radius ("radius >= 0") and half axes that are linearly dependent ("obb.half_axes",
/// "linearly independent"). Contract: reference/volumes/sphere_obb.h.
Contact sphere_obb(const Sphere3d& sphere, const Obb3d& obb);

namespace stages {

struct sphere_obb : Signatures<decltype(robust::sphere_obb)> {
  static Partial filter, enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
