// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The common velocity of two bodies after they met and stuck together, so that momentum is kept.
///
/// Every component is the double nearest to the exact one, for all finite doubles in every floating-point environment;
/// zero is +0. It lies between those before, so none is infinite. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so does a mass that is not positive ("mass > 0"). Contract:
/// reference/response/inelastic_collision.h.
Vector3d inelastic_collision(const Massesd& masses, const Velocitiesd& velocities);

namespace stages {

/// There is no filter: numbers have to be computed.
struct inelastic_collision : Signatures<decltype(robust::inelastic_collision)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
