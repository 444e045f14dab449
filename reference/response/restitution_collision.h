// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"

namespace touchstone::reference {

/// The velocities of two bodies after they bounced off each other with a coefficient of restitution e.
///
/// Deck p. 70: momentum is kept, and the relative velocity along the normal of the contact becomes -e times what it
/// was. So
///     c = (v1 - v2) . n / (n . n),
///     v1' = v1 - m2 (1 + e) / (m1 + m2) c n,  v2' = v2 + m1 (1 + e) / (m1 + m2) c n;
/// what is across the normal stays. e = 1 is elastic_collision; with e = 0 both move alike along the normal (across it
/// they need not: inelastic_collision has no normal). masses: positive, any unit, the same for both. velocities: any
/// unit. normal: of any length but 0, from either body to the other. e: from 0 to 1, both included, without unit. It
/// does not matter whether the bodies approach: the law also applies to those that separate.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so are a mass of 0 or less ("masses[0]",
/// "mass > 0"), n = 0 ("normal", "nonzero normal") and an e below 0 or above 1 ("e", "between 0 and 1").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-100 and 2^100 in size, so that
/// nothing overflows or underflows: with d = v1 - v2, S = |dx nx| + |dy ny| + |dz nz|, r = S / (n . n) and f = m2 (1 +
/// e) / (m1 + m2), component i of v1' is off by at most
///     (16 f r |n_i| + 2 |v1_i|) u;
/// of v2' by the same with m1 for m2. As elastic_collision.h has it, but that f is off by 4u relatively: 1 + e and its
/// product with a mass round too. In exact arithmetic the formula is always right.
/// ulps: 21 roundings behind each component (the 19 of elastic_collision, 1 + e, and its product with a mass).
template <class Real>
Velocities<Real> restitution_collision(const Masses<Real>& masses, const Velocities<Real>& velocities,
                                       const Vector3<Real>& normal, const Real& e) {
  const auto& [v1, v2] = velocities;
  const Real c = Real(dot(v1 - v2, normal) / dot(normal, normal));
  const Real mass = Real(masses.first + masses.second), bounce = Real(Real(1) + e);
  const Real first = Real(Real(bounce * masses.second) / mass), second = Real(Real(bounce * masses.first) / mass);
  return {v1 - Real(first * c) * normal, v2 + Real(second * c) * normal};
}

}  // namespace touchstone::reference
