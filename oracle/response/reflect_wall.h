// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/answers.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: v - 2 (v . n) n in rationals, n the unit vector of the axis: the reflection as it is defined for any wall.
/// Nothing is decided, and nothing is rounded: there is no margin.
///
/// Certificate: "components": `squared_speeds` before and after, which are equal.
template <Exact Number = double>
Truth<Vector3<Rational>> reflect_wall(const Vector3<Number>& velocity, Axis axis);

}  // namespace touchstone::oracle
