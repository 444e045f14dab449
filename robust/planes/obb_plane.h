// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether an oriented box and the half-space normal . p + offset <= 0, the plane and its back, as closed
/// solids, are `disjoint`, only touch or overlap.
///
/// `touching`: the box only reaches the plane from in front. A box within the half-space overlaps it. The half axes
/// need not be perpendicular: the box is the parallelepiped that they span, exactly. Right for all finite doubles in
/// every floating-point environment. NaN and infinities throw InvalidInput, which names the field and "finite number";
/// so do half axes that are linearly dependent ("obb.half_axes", "linearly independent") and a normal of length 0
/// ("nonzero normal"). Contract: reference/planes/obb_plane.h.
Contact obb_plane(const Obb3d& obb, const Plane3d& plane);

namespace stages {

struct obb_plane : Signatures<decltype(robust::obb_plane)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
