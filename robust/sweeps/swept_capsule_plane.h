// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/capsules.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when a capsule that moves along a straight line, without turning, first has a common point with a plane: `hit`
/// with the first t in [0, 1], counted in steps, or `never`. A capsule is the set of points no farther than its radius
/// from its segment.
///
/// The plane is the thin closed set normal . p + offset = 0, not the half-space behind it. Touching is a hit; a capsule
/// that meets the plane at the start hits at t = 0; radius 0 is a segment, a segment of length 0 a ball, and the
/// velocity may be 0. Right for all finite doubles in every floating-point environment, and t correctly rounded. NaN
/// and infinities throw InvalidInput, which names the field and "finite number"; so do a negative radius ("radius >=
/// 0") and a normal of length 0 ("nonzero normal"). Contract: reference/sweeps/swept_capsule_plane.h.
FirstContact<double> swept_capsule_plane(const Capsule3d& capsule, const Vector3d& velocity, const Plane3d& plane);

namespace stages {

/// The stages of swept_sphere_plane for both ends.
struct swept_capsule_plane : Signatures<decltype(robust::swept_capsule_plane)> {
  static Partial filter, enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
