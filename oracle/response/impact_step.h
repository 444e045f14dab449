// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/impacts.h"
#include "oracle/exact/numbers/surd.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the time of every pair as a surd, and the least of them by comparing surds; velocities after by
/// `simultaneous_collisions` at a rational moment, and at others by the conditions of Karush, Kuhn and Tucker, tried
/// for each set of contacts that may push. No margin: moments, distances and speeds have no common unit.
///
/// Certificate: "moments": for each moment that is answered one of the kind "pushes". r is the radicand of its t, 0 if
/// that is rational. `impulses` and `impulses_of_root`, a and b of a + b sqrt(r), one for each contact; `clock`;
/// `states`, position and velocity of each movable body in a contact, in ascending order, each number rounded.
template <Exact Number = double>
Truth<ImpactStep<Surd>> impact_step(const std::vector<StepBody<Number>>& bodies,
                                    const std::vector<Plane<Number>>& walls, const Number& restitution,
                                    const Number& timestep);

}  // namespace touchstone::oracle
