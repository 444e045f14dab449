// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when an oriented box that moves along a straight line, without turning, first has a common point with one at
/// rest: `hit` with the first t in [0, 1], counted in steps, or `never`.
///
/// a moves, b rests. Touching is a hit, grazing too; boxes that meet at the start hit at t = 0; the velocity may be 0.
/// The half axes need not be at right angles. Right for all finite doubles in every floating-point environment, and t
/// correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite number"; so do half axes
/// that are linearly dependent ("linearly independent"). Contract: reference/sweeps/swept_obb_obb.h.
FirstContact<double> swept_obb_obb(const Obb3d& a, const Obb3d& b, const Vector3d& velocity);

namespace stages {

/// The filter decides the steps that hit at the start, and those that never do: then there is no number to compute.
struct swept_obb_obb : Signatures<decltype(robust::swept_obb_obb)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
