// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when a ball that moves along a straight line first has a common point with a plane: `hit` with the first t in
/// [0, 1], counted in steps, or `never`.
///
/// The plane is the thin closed set normal . p + offset = 0, not the half-space behind it. Touching is a hit; a ball
/// that meets the plane at the start hits at t = 0; radius 0 is a point, and the velocity may be 0. Right for all
/// finite doubles in every floating-point environment, and t correctly rounded. NaN and infinities throw InvalidInput,
/// which names the field and "finite number"; so do a negative radius ("radius >= 0") and a normal of length 0
/// ("nonzero normal"). Contract: reference/sweeps/swept_sphere_plane.h.
FirstContact<double> swept_sphere_plane(const Sphere3d& sphere, const Vector3d& velocity, const Plane3d& plane);

namespace stages {

/// The filter decides the steps that hit at the start, and those that never do: then there is no number to compute.
/// There is no lattice: squares of heights exceed it.
struct swept_sphere_plane : Signatures<decltype(robust::swept_sphere_plane)> {
  static Partial filter, enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
