// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The velocities of two bodies after they bounced off each other with a coefficient of restitution e, from 0 to 1:
/// momentum is kept, the relative velocity along the normal of their contact is multiplied by -e, and the tangential
/// components stay.
///
/// The normal may have any length but 0, and point to either body. Bodies that part are answered by the same law. Every
/// component is the double nearest to the exact one, for all finite doubles in every floating-point environment; beyond
/// the range it is infinite, and zero is +0. NaN and infinities throw InvalidInput, which names the field and "finite
/// number"; so do a mass that is not positive ("mass > 0"), a normal of length 0 ("nonzero normal") and an e out of
/// bounds ("between 0 and 1"). Contract: reference/response/restitution_collision.h.
Velocitiesd restitution_collision(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& normal,
                                  double e);

namespace stages {

/// There is no filter: numbers have to be computed. Their degree is 8, too high for the lattice.
struct restitution_collision : Signatures<decltype(robust::restitution_collision)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
