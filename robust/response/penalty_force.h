// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/invalid_input.h"
#include "geometry/space.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The force on a particle behind a plane, all points with normal . p + offset = 0: a spring and a damper along the
/// normal. On the plane and in front of it the force is 0; behind, the damper acts both inwards and outwards.
///
/// The normal may have any length but 0, stiffness and damping may be any finite numbers. Every component is the double
/// nearest to the exact one, for all finite doubles in every floating-point environment; beyond the range it is
/// infinite, and zero is +0. NaN and infinities throw InvalidInput, which names the field and "finite number"; so does
/// a normal of length 0 ("nonzero normal"). Contract: reference/response/penalty_force.h.
Vector3d penalty_force(const Point3d& point, const Vector3d& velocity, const Plane3d& plane, double stiffness,
                       double damping);

namespace stages {

/// There is no filter: numbers have to be computed. Their degree is 4 and more, too high for the lattice.
struct penalty_force : Signatures<decltype(robust::penalty_force)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
