// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"
#include "geometry/invalid_input.h"
#include "robust/kernel/filters/staged.h"

namespace touchstone::robust {

/// The total momentum of bodies, the sum of mass times velocity; no bodies have the momentum 0.
///
/// Every component is the double nearest to the exact sum, for all finite doubles in every floating-point environment,
/// in whatever order the bodies come; beyond the range it is infinite, and zero is +0. NaN and infinities throw
/// InvalidInput, which names the field and "finite number"; so does a mass that is not positive ("mass > 0"). Contract:
/// reference/response/momentum.h.
Vector3d momentum(const std::vector<Bodyd>& bodies);

namespace stages {

/// There is no filter: numbers have to be computed.
struct momentum : Signatures<decltype(robust::momentum)> {
  static Partial enclosed;
  static Total exact;
  static Staged ask;
};

}  // namespace stages

}  // namespace touchstone::robust
