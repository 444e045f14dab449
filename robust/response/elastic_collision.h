// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The velocities of two bodies after they bounced off each other without loss: momentum and kinetic energy are kept,
/// and so are the tangential components.
///
/// The normal may have any length but 0, and point to either body. Bodies that part are answered by the same law. Every
/// component is the double nearest to the exact one, for all finite doubles in every floating-point environment; beyond
/// the range it is infinite, and zero is +0. NaN and infinities throw InvalidInput, which names the field and "finite
/// number"; so do a mass that is not positive ("mass > 0") and a normal of length 0 ("nonzero normal"). Contract:
/// reference/response/elastic_collision.h.
Velocitiesd elastic_collision(const Massesd& masses, const Velocitiesd& velocities, const Vector3d& normal);

namespace stages {

/// There is no filter: numbers have to be computed. Their degree is 7, too high for the lattice.
struct elastic_collision : Signatures<decltype(robust::elastic_collision)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
