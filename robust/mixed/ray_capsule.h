// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "robust/kernel/solids/ball_passage.h"

namespace touchstone::robust {

/// Finds where a ray enters and leaves a capsule: `hit` with the first and the last t, in units of the direction's
/// length; or `none`.
///
/// Touching is a hit, sliding along the cylinder too. first is 0 if the origin is in the capsule. A segment of length 0
/// makes it a ball, radius 0 a segment. Right for all finite doubles in every floating-point environment, and both
/// numbers correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite number"; so do a
/// direction of length 0 ("nonzero direction") and a negative radius ("radius >= 0"). Contract:
/// reference/mixed/ray_capsule.h.
Passage<double> ray_capsule(const Ray3d& ray, const Capsule3d& capsule);

namespace stages {

struct ray_capsule : kernel::CapsulePassage {
  static Decided<Passage<double>> ask(const kernel::Line& ray, const Capsule3d& capsule);
};

}  // namespace stages

}  // namespace touchstone::robust
