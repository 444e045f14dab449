// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a ball and a closed triangle in space are `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point, and no interior point of the ball is in the triangle: the ball only reaches
/// it, or has the radius 0. A triangle without area is the segment or the point that its corners span. Right for all
/// finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the field and
/// "finite number"; so does a negative radius ("radius >= 0"). Contract: reference/mixed/sphere_triangle.h.
Contact sphere_triangle(const Sphere3d& sphere, const Triangle3d& triangle);

namespace stages {

/// The filter first decides balls that are beyond the box around the corners.
struct sphere_triangle : Signatures<decltype(robust::sphere_triangle)> {
  static Partial filter, enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
