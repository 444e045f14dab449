// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a closed triangle in space and an oriented box are `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point, and no interior point of the box is in the triangle. A triangle without area
/// is the segment or the point that its corners span. The half axes need not be perpendicular: the box is the
/// parallelepiped that they span, exactly. Right for all finite doubles in every floating-point environment. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so do half axes that are linearly
/// dependent ("obb.half_axes", "linearly independent"). Contract: reference/mixed/triangle_obb.h.
Contact triangle_obb(const Triangle3d& triangle, const Obb3d& obb);

namespace stages {

struct triangle_obb : Signatures<decltype(robust::triangle_obb)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
