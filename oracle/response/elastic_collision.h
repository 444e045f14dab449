// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"
#include "oracle/truth.h"

namespace touchstone::oracle {

/// Truth: momentum and the relative velocity along the normal, of which only the sign changes, are two linear equations
/// for what the bodies have along the normal; across it their velocities stay. Nothing is decided: there is no margin.
///
/// Certificate: "impulse": the number `impulse` j with m1 (v1' - v1) = j n, and `doubled_energies`, m1 v1 . v1 + m2 v2
/// . v2 before and after.
template <Exact Number = double>
Truth<Velocities<Rational>> elastic_collision(const Masses<Number>& masses, const Velocities<Number>& velocities,
                                              const Vector3<Number>& normal);

}  // namespace touchstone::oracle
