// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether an axis-aligned box and the half-space normal . p + offset <= 0, the plane and its back, as closed
/// solids, are `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point and no common interior point: the box only reaches the plane from in front; or
/// it is flat, because min == max on an axis, and some of it is in the half-space, however deep. A box within the
/// half-space overlaps it. Right for all finite doubles in every floating-point environment. NaN and infinities throw
/// InvalidInput, which names the field and "finite number"; so do min > max ("min <= max") and a normal of length 0
/// ("nonzero normal"). Contract: reference/mixed/aabb_plane.h.
Contact aabb_plane(const Aabb3d& aabb, const Plane3d& plane);

namespace stages {

struct aabb_plane : Signatures<decltype(robust::aabb_plane)> {
  static Partial filter, lattice;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
