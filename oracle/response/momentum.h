// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: summed by parts, each step from one velocity to the next times the mass of all bodies up to there. Nothing is
/// decided: there is no margin.
///
/// Certificate: "sum": no facts; momentum is a sum that can be checked by summing.
template <Exact Number = double>
Truth<Vector3<Rational>> momentum(const std::vector<Body<Number>>& bodies);

}  // namespace touchstone::oracle
