// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "geometry/bodies.h"

namespace touchstone::reference {

/// The velocities of two bodies after they bounced off each other without loss.
///
/// Deck p. 69: momentum and kinetic energy are kept. The impulse is along the normal of the contact, so that
///     c = (v1 - v2) . n / (n . n),
///     v1' = v1 - 2 m2 / (m1 + m2) c n,  v2' = v2 + 2 m1 / (m1 + m2) c n;
/// what is across the normal stays. masses: positive, any unit, the same for both. velocities: any unit. normal: of any
/// length but 0, from either body to the other. It does not matter whether the bodies approach: the law also applies to
/// those that separate, and to those that do neither, which keep their velocities.
/// NaN or infinity: refused by robust and oracle (field, "finite number"); so are a mass of 0 or less ("masses[0]",
/// "mass > 0") and n = 0 ("normal", "nonzero normal").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-100 and 2^100 in size, so that
/// nothing overflows or underflows: with d = v1 - v2, S = |dx nx| + |dy ny| + |dz nz|, r = S / (n . n) and f = 2 m2 /
/// (m1 + m2), component i of v1' is off by at most
///     (14 f r |n_i| + 2 |v1_i|) u;
/// of v2' by the same with m1 for m2. d . n is off by 4u S, n . n by 3u relatively, so c by 8u r; f is off by 2u
/// relatively, its products with c and n_i round: 12. The difference rounds with u (|v1_i| + f r |n_i|), and one of
/// each is for what is of higher order. In exact arithmetic the formula is always right.
/// ulps: 19 roundings behind each component (three differences, three products and two sums in d . n, as many in
/// n . n, quotient; sum and quotient of masses; two products, difference).
template <class Real>
Velocities<Real> elastic_collision(const Masses<Real>& masses, const Velocities<Real>& velocities,
                                   const Vector3<Real>& normal) {
  const auto& [v1, v2] = velocities;
  const Real c = Real(dot(v1 - v2, normal) / dot(normal, normal));
  const Real mass = Real(masses.first + masses.second);
  const Real first = Real(Real(Real(2) * masses.second) / mass), second = Real(Real(Real(2) * masses.first) / mass);
  return {v1 - Real(first * c) * normal, v2 + Real(second * c) * normal};
}

}  // namespace touchstone::reference
