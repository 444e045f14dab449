// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/invalid_input.h"
#include "geometry/triangles.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Decides whether a capsule and a closed triangle in space are `disjoint`, only touch or overlap.
///
/// `touching`: they have a common point, and no interior point of the capsule is in the triangle: the capsule only
/// reaches it, or has the radius 0. A triangle without area is the segment or the point that its corners span. Right
/// for all finite doubles in every floating-point environment. NaN and infinities throw InvalidInput, which names the
/// field and "finite number"; so does a negative radius ("radius >= 0"). Contract: reference/mixed/capsule_triangle.h.
Contact capsule_triangle(const Capsule3d& capsule, const Triangle3d& triangle);

namespace stages {

struct capsule_triangle : Signatures<decltype(robust::capsule_triangle)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
