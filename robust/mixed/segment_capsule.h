// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "robust/kernel/solids/ball_passage.h"

namespace touchstone::robust {

/// Finds where a closed segment enters and leaves a capsule: `hit` with the first and the last t, 0 at a and 1 at b; or
/// `none`.
///
/// Touching is a hit, sliding along the cylinder too. first is 0 if a is in the capsule, last is 1 where b is; a
/// segment of length 0 is a point, both are 0. A capsule's own segment of length 0 makes it a ball, radius 0 a segment.
/// Right for all finite doubles in every floating-point environment, and both numbers correctly rounded. NaN and
/// infinities throw InvalidInput, which names the field and "finite number"; so does a negative radius ("radius >= 0").
/// Contract: reference/mixed/segment_capsule.h.
Passage<double> segment_capsule(const Segment3d& segment, const Capsule3d& capsule);

namespace stages {

struct segment_capsule : kernel::CapsulePassage {
  static Decided<Passage<double>> ask(const kernel::Line& segment, const Capsule3d& capsule);
};

}  // namespace stages

}  // namespace touchstone::robust
