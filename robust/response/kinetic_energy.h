// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The total kinetic energy of bodies, half the sum of mass times squared speed; no bodies have the energy 0.
///
/// The double nearest to the exact sum, for all finite doubles in every floating-point environment, in whatever order
/// the bodies come; beyond the range it is infinite, and zero is +0. NaN and infinities throw InvalidInput, which names
/// the field and "finite number"; so does a mass that is not positive ("mass > 0"). Contract:
/// reference/response/kinetic_energy.h.
double kinetic_energy(const std::vector<Bodyd>& bodies);

namespace stages {

/// There is no filter: numbers have to be computed.
struct kinetic_energy : Signatures<decltype(robust::kinetic_energy)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
