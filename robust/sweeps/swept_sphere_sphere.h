// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "geometry/invalid_input.h"
#include "geometry/volumes.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// Finds when two balls that move along straight lines first have a common point: `hit` with the first t in [0, 1],
/// counted in steps, or `never`.
///
/// Touching is a hit; balls that meet at the start hit at t = 0; radius 0 is a point, and velocities may be 0. Right
/// for all finite doubles in every floating-point environment, and t correctly rounded. NaN and infinities throw
/// InvalidInput, which names the field and "finite number"; so does a negative radius ("radius >= 0"). Contract:
/// reference/sweeps/swept_sphere_sphere.h.
FirstContact<double> swept_sphere_sphere(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                         const Vector3d& velocity_b);

/// The decision alone, which costs less.
HitRelation swept_sphere_sphere_relation(const Sphere3d& a, const Sphere3d& b, const Vector3d& velocity_a,
                                         const Vector3d& velocity_b);

namespace stages {

/// The filter of the full answer decides the sweeps that hit at the start, and those that never do: then there is no
/// number to compute.
struct swept_sphere_sphere : Signatures<decltype(robust::swept_sphere_sphere)> {
  static Partial filter, enclosed, lattice;
  static Total exact;
  static Staged ask;

  struct decision : Signatures<decltype(robust::swept_sphere_sphere_relation)> {
    static Partial filter, lattice;
    static Total exact;
    static Staged ask;
  };
};

}  // namespace stages

}  // namespace touchstone::robust
