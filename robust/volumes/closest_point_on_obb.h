// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The point of an oriented box, as a closed solid, that is nearest to a point, the distance and its square: the point
/// itself and 0 if it lies in the box.
///
/// The half axes need not be perpendicular: the box is the parallelepiped that they span, exactly. Right for all finite
/// doubles in every floating-point environment, and every number correctly rounded on its own: the distance is neither
/// the root of the rounded square nor measured from the rounded point. NaN and infinities throw InvalidInput, which
/// names the field and "finite number"; so do half axes that are linearly dependent ("obb.half_axes", "linearly
/// independent"). Contract: reference/volumes/closest_point_on_obb.h.
ClosestPoint3<double> closest_point_on_obb(const Point3d& point, const Obb3d& obb);

namespace stages {

struct closest_point_on_obb : Signatures<decltype(robust::closest_point_on_obb)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
