// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/closest.h"
#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether two closed triangles in space have a common point; if not, returns a pair of nearest points, their
/// distance and its square.
///
/// Touching is `meeting`: both distances are 0, without points. If several pairs are nearest, the one whose point on a
/// is nearest to a's first corner. A triangle without area is the segment or the point that its corners span. Right for
/// all finite doubles in every floating-point environment, and every number correctly rounded on its own. NaN and
/// infinities throw InvalidInput, which names the field and "finite number". Contract:
/// reference/mixed/triangle_triangle_distance.h.
ConvexDistance<double> triangle_triangle_distance(const Triangle3d& a, const Triangle3d& b);

namespace stages {

struct triangle_triangle_distance : Signatures<decltype(robust::triangle_triangle_distance)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
