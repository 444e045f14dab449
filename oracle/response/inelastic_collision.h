// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: the point that divides the segment from v1 to v2 as m2 to m1, v1 + m2 / (m1 + m2) (v2 - v1), in rationals.
/// Nothing is decided: there is no margin.
///
/// Certificate: "momentum": the `momentum` m1 v1 + m2 v2.
template <Exact Number = double>
Truth<Vector3<Rational>> inelastic_collision(const Masses<Number>& masses, const Velocities<Number>& velocities);

}  // namespace touchstone::oracle
