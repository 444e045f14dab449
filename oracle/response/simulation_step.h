// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/steps.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: free flight, distances and heights in rationals; velocities after by `simultaneous_collisions`, for which
/// walls are one more body, immovable, with a contact each. No margin: contacts are found by squares of distances and
/// by speeds, which have no common unit. Time: that of `simultaneous_collisions`, and all pairs.
///
/// Certificate: "pushes": `impulses`, one for each contact of the truth, as of `simultaneous_collisions`.
template <Exact Number = double>
Truth<NextState<Rational>> simulation_step(const std::vector<StepBody<Number>>& bodies,
                                           const std::vector<Plane<Number>>& walls,
                                           const StepSettings<Number>& settings);

}  // namespace touchstone::oracle
