// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when a capsule that moves along a straight line, without turning, first has a common point with a capsule at
/// rest: `hit` with the first t in [0, 1], counted in steps, or `never`.
///
/// a moves, b rests. Touching is a hit; capsules that meet at the start hit at t = 0. A segment of length 0 makes a
/// ball, radius 0 a segment, and the velocity may be 0. Right for all finite doubles in every floating-point
/// environment, and t correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite
/// number"; so does a negative radius ("radius >= 0"). Contract: reference/sweeps/swept_capsule_capsule.h.
FirstContact<double> swept_capsule_capsule(const Capsule3d& a, const Capsule3d& b, const Vector3d& velocity);

namespace stages {

/// The filter decides the steps that hit at the start, and those that never do: then there is no number to compute.
struct swept_capsule_capsule : Signatures<decltype(robust::swept_capsule_capsule)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
