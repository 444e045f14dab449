// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: by Koenig's theorem, the energy of all mass at the velocity of its centre plus the energy of the bodies
/// relative to it. Nothing is decided: there is no margin.
///
/// Certificate: "centre": the `mass` of all, the `velocity` of their centre and `doubled_energies`: of all mass there,
/// and of the bodies as seen from it. None have the velocity 0.
template <Exact Number = double>
Truth<Rational> kinetic_energy(const std::vector<Body<Number>>& bodies);

}  // namespace touchstone::oracle
