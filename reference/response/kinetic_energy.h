// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"

namespace touchstone::reference {

/// The kinetic energy of bodies together.
///
/// Deck p. 66: the sum over all bodies
///     E = sum m v . v / 2.
/// bodies: any number; none have the energy 0. mass: positive. Both units are free, and the answer is in mass times
/// squared velocity. It is never negative, and 0 if all bodies rest.
/// NaN or infinity: refused by robust and oracle (field "bodies[0].mass" ..., "finite number"); so is a mass of 0 or
/// less ("mass > 0").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-100 and 2^100 in size, so that
/// nothing overflows or underflows: of N bodies the energy is off by at most
///     (N + 4) u relatively
/// for N up to 2^25: three roundings behind each square in v . v, its product with m, N - 1 sums, and one for what is
/// of higher order; halving is exact, and nothing cancels. In exact arithmetic the formula is always right.
/// ulps: 56 roundings behind the energy of eight bodies (three products and two sums each, a product and a sum).
template <class Real>
Real kinetic_energy(const std::vector<Body<Real>>& bodies) {
  Real sum = Real(0);
  for (const Body<Real>& body : bodies) sum = Real(sum + body.mass * dot(body.velocity, body.velocity));
  return Real(sum / Real(2));
}

}  // namespace touchstone::reference
