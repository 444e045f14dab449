// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The point of a closed triangle in space that is nearest to a point, the distance and its square.
///
/// A triangle without area is the segment or the point that its corners span. Right for all finite doubles in every
/// floating-point environment, and every number correctly rounded on its own: the distance is neither the root of the
/// rounded square nor measured from the rounded point. NaN and infinities throw InvalidInput, which names the field and
/// "finite number". Contract: reference/mixed/closest_point_on_triangle.h.
ClosestPoint3<double> closest_point_on_triangle(const Point3d& point, const Triangle3d& triangle);

namespace stages {

struct closest_point_on_triangle : Signatures<decltype(robust::closest_point_on_triangle)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
