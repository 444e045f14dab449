// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "robust/kernel/stage.h"

namespace touchstone::robust {

/// Contract: reference/lines/parametric_circle.h. Both coordinates correctly rounded for all finite doubles, in every
/// floating-point environment. There is one stage: fixed-point sine and cosine on integers of any size, with bounds on
/// both sides, until both bounds round to the same double (robust/kernel/sine_cosine.h).
Point2d parametric_circle(const Circle2d& circle, double u);

/// The same, and which stage decided: always Stage::exact.
Point2d parametric_circle(const Circle2d& circle, double u, Stage& decided);

}  // namespace touchstone::robust
