// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The point (center.x + radius cos u, center.y + radius sin u) of a circle; u in radians, of any size,
/// counter-clockwise from the +x axis, y up.
///
/// Both coordinates correctly rounded for all finite doubles, in every floating-point environment: fixed-point sine and
/// cosine on integers of any size, with bounds on both sides, until both bounds round to the same double. Radius 0
/// gives the center. NaN and infinities throw InvalidInput, which names the field and "finite number"; so does a
/// negative radius ("radius >= 0"). Contract: reference/lines/parametric_circle.h.
Point2d parametric_circle(const Circle2d& circle, double u);

namespace stages {

/// There is no filter: a number has to be computed.
struct parametric_circle : Signatures<decltype(robust::parametric_circle)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
