// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"

namespace touchstone::reference {

/// The velocity that two bodies have in common after they met and stuck together.
///
/// Deck p. 70: momentum is kept,
///     v = (m1 v1 + m2 v2) / (m1 + m2).
/// masses: positive, any unit, the same for both. velocities: any unit. Nothing else of the bodies counts: neither
/// where they touch nor whether they approach. Equal velocities stay what they are.
/// NaN or infinity: refused by robust and oracle (field "masses[0]" ..., "finite number"); so is a mass of 0 or less
/// ("mass > 0").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-100 and 2^100 in size, so that
/// nothing overflows or underflows: component i is off by at most
///     5 (m1 |v1_i| + m2 |v2_i|) / (m1 + m2) u,
/// for the products, their sum, the sum of the masses and the quotient, and one for what is of higher order. In exact
/// arithmetic the formula is always right.
/// ulps: 5 roundings behind each component (two products, two sums, quotient).
template <class Real>
Vector3<Real> inelastic_collision(const Masses<Real>& masses, const Velocities<Real>& velocities) {
  const Vector3<Real> momentum = masses.first * velocities.first + masses.second * velocities.second;
  const Real mass = Real(masses.first + masses.second);
  return {Real(momentum.x / mass), Real(momentum.y / mass), Real(momentum.z / mass)};
}

}  // namespace touchstone::reference
