// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The motion of two rotating bodies after they collided at a point, with a coefficient of restitution e, from 0 to 1:
/// an impulse along the normal keeps momentum and angular momentum and multiplies the relative velocity of the two
/// points at the contact, along the normal, by -e.
///
/// The normal may have any length but 0, and point to either body. Bodies that part are answered by the same law. Every
/// component is the double nearest to the exact one, for all finite doubles in every floating-point environment; beyond
/// the range it is infinite, and zero is +0. NaN and infinities throw InvalidInput, which names the field and "finite
/// number"; so do, body by body, an inertia that is not symmetric ("symmetric"), a mass that is not positive ("mass >
/// 0") and an inertia that is not positive definite, exactly ("positive definite"), a normal of length 0 ("nonzero
/// normal") and an e out of bounds ("between 0 and 1"). Contract: reference/response/rigid_body_collision.h.
Motions<double> rigid_body_collision(const RigidBodyd& a, const RigidBodyd& b, const Point3d& point,
                                     const Vector3d& normal, double e);

namespace stages {

/// There is no filter: numbers have to be computed. They fit no lattice.
struct rigid_body_collision : Signatures<decltype(robust::rigid_body_collision)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
