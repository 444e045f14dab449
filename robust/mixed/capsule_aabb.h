// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a capsule and an axis-aligned box, as closed solids, are `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point and no common interior point: the capsule only reaches the box, or has the
/// radius 0, or the box is flat. Right for all finite doubles in every floating-point environment. NaN and infinities
/// throw InvalidInput, which names the field and "finite number"; so do a negative radius ("radius >= 0") and min > max
/// ("min <= max"). Contract: reference/mixed/capsule_aabb.h.
Contact capsule_aabb(const Capsule3d& capsule, const Aabb3d& aabb);

namespace stages {

struct capsule_aabb : Signatures<decltype(robust::capsule_aabb)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
