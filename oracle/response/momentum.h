// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"
#include "oracle/certificates/certificate.h"

namespace touchstone::oracle {

/// Truth: summed by parts, each step from one velocity to the next times the mass of all bodies up to there. Nothing is
/// decided: there is no margin.
Truth<Vector3<Rational>> momentum(const std::vector<Bodyd>& bodies);
template <Exact Number>
Truth<Vector3<Rational>> momentum(const std::vector<Body<Number>>& bodies);

/// "sum": no facts; momentum is a sum that can be checked by summing.
Certificate momentum_certificate(const std::vector<Bodyd>& bodies);

}  // namespace touchstone::oracle
