// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "geometry/bodies.h"

namespace touchstone::reference {

/// The momentum of bodies together.
///
/// Deck p. 65: the sum over all bodies
///     p = sum m v.
/// bodies: any number; none have the momentum 0. mass: positive. Both units are free, and the answer is in their
/// product.
/// NaN or infinity: refused by robust and oracle (field "bodies[0].mass" ..., "finite number"); so is a mass of 0 or
/// less ("mass > 0").
///
/// Rounding (binary64, to nearest, u = 2^-53), where every number is 0 or between 2^-100 and 2^100 in size, so that
/// nothing overflows or underflows: of N bodies component i is off by at most
///     (N + 1) u (m1 |v1_i| + m2 |v2_i| + ...)
/// for N up to 2^25: the product and at most N - 1 sums round behind each term (the first sum is with 0, and exact),
/// and one is for what is of higher order. It is relative to the sum of the sizes: where velocities cancel, a component
/// has no right digit. In exact arithmetic the formula is always right.
/// ulps: 16 roundings behind each component of eight bodies (eight products, eight sums).
template <class Real>
Vector3<Real> momentum(const std::vector<Body<Real>>& bodies) {
  Vector3<Real> sum{Real(0), Real(0), Real(0)};
  for (const Body<Real>& body : bodies) sum = sum + body.mass * body.velocity;
  return sum;
}

}  // namespace touchstone::reference
