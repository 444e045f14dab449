// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when a ball that moves along a straight line first has a common point with an axis-aligned box at rest: `hit`
/// with the first t in [0, 1], counted in steps, or `never`.
///
/// Touching is a hit; a ball that meets the box, which is solid, at the start hits at t = 0; radius 0 is a point, the
/// box may be flat, and the velocity may be 0. Right for all finite doubles in every floating-point environment, and t
/// correctly rounded. NaN and infinities throw InvalidInput, which names the field and "finite number"; so do a
/// negative radius ("radius >= 0") and min > max ("min <= max"). Contract: reference/sweeps/swept_sphere_aabb.h.
FirstContact<double> swept_sphere_aabb(const Sphere3d& sphere, const Vector3d& velocity, const Aabb3d& aabb);

namespace stages {

/// The filter decides the steps that hit at the start, and those that never do: then there is no number to compute.
/// There is no lattice: squared distances at rational times exceed it.
struct swept_sphere_aabb : Signatures<decltype(robust::swept_sphere_aabb)> {
  static Partial filter;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
